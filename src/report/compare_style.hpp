#pragma once
/// The style sheet of the page of a comparison.

#include <string_view>

namespace ligne {

/// Dark lines on a light page, one accent colour for differences, figures in columns. Lines of drawings are in mm of
/// the page.
inline constexpr std::string_view kCompareStyle = R"css(
:root{--ink:#1c1b19;--soft:#6f6a62;--faint:#e4dfd6;--paper:#faf8f4;--card:#fff;--red:#d0021b;--blue:#2b5c8a;--bar:#c9d6e2}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 "Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif}
main{max-width:1280px;margin:0 auto;padding:44px 36px 72px}
h1{font:600 34px/1.15 Georgia,"Liberation Serif",serif;margin:0 0 6px;overflow-wrap:anywhere}
h2{font:600 21px/1.2 Georgia,"Liberation Serif",serif;margin:52px 0 4px}
p{margin:0 0 12px;max-width:76ch}
.lead{font-size:17px;color:var(--soft)}
.soft{color:var(--soft)}
.verdict{display:inline-block;margin:10px 0 26px;padding:7px 14px;border-radius:4px;background:#e9f1ea;color:#22592e;font-weight:600}
.verdict.differs{background:#fbe6e8;color:#9c0214}
.top{display:grid;grid-template-columns:minmax(0,1.75fr) minmax(300px,1fr);gap:28px;align-items:stretch}
@media(max-width:900px){.top{grid-template-columns:1fr}}
.sheet{background:var(--card);border:1px solid var(--faint);border-radius:6px;padding:14px;display:flex;align-items:center;justify-content:center}
.sheet svg{display:block;width:100%;max-height:560px}
dl{margin:0;display:grid;grid-template-columns:auto 1fr;align-content:start;background:var(--card);border:1px solid var(--faint);border-radius:6px;padding:10px 20px}
dt,dd{margin:0;padding:9px 0;border-top:1px solid var(--faint)}
dt:first-of-type,dd:first-of-type{border-top:0}
dt{color:var(--soft);padding-right:18px}
dd{text-align:right;font-variant-numeric:tabular-nums}
dd b{font-size:17px}
dd span{display:block;color:var(--soft);font-size:13px}
.scroll{overflow-x:auto;margin-top:14px}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums;background:var(--card);border:1px solid var(--faint);border-radius:6px}
th,td{padding:8px 14px;text-align:right;white-space:nowrap;border-top:1px solid var(--faint)}
thead th{color:var(--soft);font-weight:500;font-size:13px;border-top:0;vertical-align:bottom}
tbody th,thead th:first-child,td.text{text-align:left}
tbody th{font-weight:600}
tbody th small{display:block;font-weight:400;color:var(--soft);white-space:normal;max-width:44ch}
td.time{min-width:260px;text-align:left}
.bar{display:flex;align-items:center;gap:9px}
.bar i{display:block;height:13px;background:var(--bar);border-radius:0 2px 2px 0;min-width:2px;overflow:hidden}
.bar i u{display:block;height:100%;background:var(--blue)}
.key{display:inline-block;width:11px;height:11px;margin:0 5px 0 12px;border-radius:2px;vertical-align:-1px}
.best th:after{content:"fastest";margin-left:9px;padding:1px 7px;border-radius:9px;background:var(--blue);color:#fff;font-size:11px;font-weight:500;vertical-align:1px}
.red{color:var(--red);font-weight:600}
.zero{color:#a8a299}
.same{background:#f3f1ec}
.off{background:#fbe6e8;color:#9c0214;font-weight:600}
.parts th,.parts td{text-align:left;vertical-align:top;font-size:13.5px}
.parts td{white-space:normal;min-width:30ch}
.matrix{width:auto}
.matrix th,.matrix td{padding:7px 11px;font-size:13.5px}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(340px,1fr));gap:20px;margin-top:16px}
figure{margin:0;background:var(--card);border:1px solid var(--faint);border-radius:6px;overflow:hidden;display:flex;flex-direction:column}
figure a{display:flex;align-items:center;padding:12px;flex:1}
figure svg{display:block;width:100%;height:270px;--pen:1.9}
figcaption{padding:10px 14px;border-top:1px solid var(--faint);display:flex;justify-content:space-between;gap:12px;align-items:baseline}
figcaption b{font-size:16px}
figcaption span{color:var(--soft);font-size:13px;text-align:right;font-variant-numeric:tabular-nums}
figure .none{flex:1;display:flex;align-items:center;justify-content:center;min-height:274px;padding:30px;color:var(--soft);text-align:center}
.note{padding:0 14px 11px;color:var(--soft);font-size:13px}
.big{display:none;position:fixed;inset:0;background:rgba(250,248,244,.97);padding:34px;z-index:9}
.big:target{display:block}
.big svg{width:100%;height:100%}
.big p{position:absolute;left:36px;top:14px;font-weight:600}
g{fill:none;stroke:var(--ink);stroke-width:calc(.3px*var(--pen,1));stroke-linecap:round;stroke-linejoin:round}
g.profile{stroke-width:calc(.7px*var(--pen,1))}
g.outline,g.border{stroke-width:calc(.5px*var(--pen,1))}
g.mesh{stroke-width:calc(.18px*var(--pen,1))}
g.hidden{stroke:#8d8880;stroke-width:calc(.2px*var(--pen,1));stroke-dasharray:1.6 1.1}
g.lost{stroke:var(--red);stroke-width:1.3}
g.more{stroke:var(--red);stroke-width:1.3;stroke-dasharray:.1 2.1}
g.spots{stroke:var(--red);stroke-width:.6}
footer{margin-top:56px;padding-top:16px;border-top:1px solid var(--faint);color:var(--soft);font-size:13px}
@media print{.grid{grid-template-columns:repeat(2,1fr)}figure,table{break-inside:avoid}}
)css";

}  // namespace ligne
