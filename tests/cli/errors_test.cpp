/// Every way to get the command line wrong: exit status, one line on standard error, no file left behind.

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <new>

#include "program.hpp"

namespace ligne::test {
namespace {

struct Mistake {
  const char* name;
  Words arguments;
  int status;
  std::string start;  ///< of the line, behind "ligne: "
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class Mistakes : public ProgramTest, public testing::WithParamInterface<Mistake> {};

TEST_P(Mistakes, AreOneLineAndLeaveNothing) {
  const Outcome outcome = run(GetParam().arguments);
  EXPECT_EQ(outcome.status, GetParam().status) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("ligne: " + GetParam().start, 0), 0u) << outcome.err;
  EXPECT_EQ(new_files(), Words{});
}

Mistake draw(const char* name, const Words& options, const std::string& start) {
  Words arguments = "draw cube.obj -o out.svg" + options;
  return {name, arguments, kUsage, start};
}

INSTANTIATE_TEST_SUITE_P(
    Options, Mistakes,
    testing::Values(
        draw("ViewUnknown", "--view behind", "--view: \"behind\" is not one of front, "),
        draw("DirectionZero", "--direction 0,0,0", "--direction: \"0,0,0\" has no direction"),
        draw("DirectionShort", "--direction 1,2", "--direction: \"1,2\" is not three numbers X,Y,Z"),
        draw("DirectionWithView", "--view top --direction 1,0,0", "--"),
        draw("EyeWithDirection", "--eye 1,0,0 --direction 1,0,0", "--"),
        draw("EyeWords", "--eye here", "--eye: \"here\" is not three numbers X,Y,Z"),
        draw("EyeIsTarget", "--eye 100,0,0 --target 100,0,0", "the eye"), draw("TargetAlone", "--target 0,0,0", "--target"),
        draw("FovAlone", "--fov 40", "--fov"),
        draw("FovLarge", "--eye 99,0,0 --fov 200", "--fov: 200 is not between 0 and 180 degrees\n"),
        draw("FovZero", "--eye 99,0,0 --fov 0", "--fov: 0 is not between 0 and 180 degrees\n"),
        draw("UpZero", "--up 0,0,0", "--up: "), draw("UpAxis", "--up-axis w", "--up-axis: "),
        draw("Method", "--method magic", "--method: \"magic\" is not one of auto"),
        draw("OptionOfAnotherMethod", "--set resolution=512", "--set resolution: method appel has no such option\n"),
        draw("WarnockWindow", "--method warnock --set warnock-window=round",
             "--set warnock-window: \"round\" is not one of screen, bounding or principal\n"),
        draw("Resolution", "--method warnock --set resolution=0",
             "--set resolution: \"0\" is not a whole number from 1 to "),
        draw("SubdivisionScheme", "--subdivide doo", "--subdivide: \"doo\" is not one of catmull-clark or loop"),
        draw("SubdivisionLevels", "--subdivide loop:12", "--subdivide: "),
        draw("SubdivisionNoLevels", "--subdivide loop:", "--subdivide: "),
        draw("Edges", "--edges outline,all,none", "--edges: \"none\" is not one of outline, "),
        draw("EdgesEmpty", "--edges ''", "--edges: "), draw("CreaseNegative", "--crease -1", "--crease: -1 is not "),
        draw("WeldZero", "--weld 0", "--weld: 0 is not greater than 0\n"),
        draw("CreaseLarge", "--crease 181", "--crease: 181 is not from 0 to 180 degrees\n"),
        draw("SpanMethod", "--method watkins --set span-method=heap",
             "--set span-method: \"heap\" is not one of merge, stack, box, point or remembered\n"),
        draw("SpanMethodElsewhere", "--method appel --set span-method=box",
             "--set span-method: method appel has no such option\n"),
        draw("LinesZero", "--method watkins --lines 0", "--lines: "),
        draw("LinesWord", "--method watkins --lines many", "--lines: "),
        draw("LinesHuge", "--method watkins --lines 99999999999999999999", "--lines: "),
        draw("ShadeInJson", "--method watkins --shade --format json", "--shade: a JSON drawing has no grey faces"),
        draw("ShadeForAPlotter", "--method watkins --shade --device hp7475a --format hpgl",
             "--shade: pens draw no grey faces; see --hatch"),
        draw("ShadeInGcode", "--method zbuffer --shade --format gcode", "--shade: pens draw no grey faces; see --hatch"),
        draw("ShadeByPens", "--method zbuffer --shade --pen outline=1", "--shade: pens draw no grey faces; see --hatch"),
        draw("HatchWithoutSpans", "--method appel --hatch shade",
             "--hatch: method appel gives neither regions nor spans; regions: atherton-weiler, warnock, newell, bsp, "
             "convex-tree; spans: watkins"),
        draw(
            "HatchLength", "--hatch 1mm",
            "--hatch: \"1mm\" is not one of none, shade, material or plain; the distance of the strokes is --hatch-spacing"),
        draw("HatchNothing", "--hatch shade --hatch-spacing 0", "--hatch-spacing: "),
        draw("HatchJson", "--hatch shade --format json", "--hatch: a JSON drawing has no hatching"),
        draw("HatchTooClose", "--method watkins --hatch shade --hatch-spacing 0.00001mm",
             "--hatch-spacing: the strokes are too dense"),
        draw("HatchLevels", "--method watkins --hatch shade --hatch-levels 5", "--hatch-levels: "),
        draw("Hidden", "--hidden dotted", "--hidden: \"dotted\" is not one of none, dashed or solid\n"),
        draw("HiddenByNone", "--hidden none:2", "--hidden: none takes no number of faces\n"),
        draw("HiddenByZero", "--hidden dashed:0", "--hidden: "),
        draw("HiddenByMethod", "--method newell --hidden dashed:1",
             "--hidden: only --method appel counts faces, which dashed:N and solid:N need\n"),
        draw("Page", "--page A11", "--page: "), draw("PageNothing", "--page 0x0", "--"),
        draw("PageTwice", "--landscape --portrait", "--"), draw("MarginUnit", "--margin 1ft", "--margin: "),
        draw("MarginNegative", "--margin -1", "--margin: "),
        draw("MarginLarge", "--margin 11cm", "--margin: 110 mm leaves no drawable area on a page of 210 x 297 mm\n"),
        draw("PenZero", "--pen-width 0", "--pen-width: "), draw("PenWide", "--pen-width 6cm", "--pen-width: "),
        draw("Scale", "--scale half", "--scale: "), draw("ScaleZero", "--scale 0:1", "--scale: "),
        draw("Unit", "--unit ell", "--unit: "), draw("Dpi", "--dpi 0", "--dpi: "),
        draw("Format", "--format dxf", "--format: \"dxf\" is not one of svg, pdf, png, json, hpgl or gcode\n"),
        draw("DeviceUnknown", "--device plotomat", "--device: \"plotomat\" is not known; ligne devices lists them\n"),
        draw("DeviceSpeaksHpgl", "--device hp7475a", "--device: hp7475a takes hpgl, not svg"),
        draw("DeviceTwice", "--device cutter --device-file a.toml", "--"),
        draw("PenWithoutNumber", "--pen outline", "--pen: \"outline\" is not CLASS=N"),
        draw("PenColour", "--pen outline=1,reddish", "--pen: \"reddish\" is not a colour"),
        draw("Optimize", "--optimize well", "--optimize: \"well\" is not one of off, order, join or full\n"),
        draw("FitNoDevice", "--fit-device", "--fit-device: there is no --device\n"),
        draw("PreviewIsInput", "--preview cube.obj", "--preview: cube.obj is also an input file"),
        draw("PreviewIsOutput", "--preview out.svg", "--preview: out.svg is the output file too\n"),
        draw("JsonHasNoPens", "--format json --report", "--format: a JSON drawing has no pens"),
        draw("ThreadsZero", "--threads 0", "--threads: "), draw("ThreadsHalf", "--threads 1.5", "--threads: "),
        draw("Progress", "--progress often", "--progress: "), draw("StatsFileEmpty", "--stats-json ''", "--stats-json: "),
        draw("StatsIsOutput", "--stats-json out.svg", "--stats-json: out.svg is the output file too\n"),
        draw("StatsIsInput", "--stats-json cube.obj", "--stats-json: cube.obj is also an input file"),
        draw("Unknown", "--frobnicate", "unknown: --frobnicate; see ligne draw --help\n"),
        draw("Slip", "--veiw=iso --hiden", "unknown: --veiw=iso (--view?) --hiden (--hidden?); see ligne draw --help\n"),
        draw("ValueMissing", "--fov", "--fov: its value is missing\n"),
        draw("Twice", "--crease 10 --crease 20", "--crease: given more than once\n"),
        draw("LineBreak", {"--view", "a\nb"}, "--view: ")),
    [](const auto& info) { return std::string(info.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Files, Mistakes,
    testing::Values(
        Mistake{"NoCommand", {}, kUsage, "there is no command"},
        Mistake{"UnknownCommand", {"paint"}, kUsage, "unknown: paint; see ligne --help\n"},
        Mistake{"CommandSlip", "drwa cube.obj", kUsage, "unknown: drwa (draw?) cube.obj; see ligne --help\n"},
        Mistake{"LongForShort", "surface x*y --x=0:1", kUsage, "unknown: --x=0:1 (-x?); see ligne surface"},
        Mistake{"NoModel", "draw -o out.svg", kUsage, "MODEL"}, Mistake{"InfoNoModel", {"info"}, kUsage, "MODEL"},
        Mistake{"NoOutput", "draw cube.obj", kUsage, "--output: there is no output file"},
        Mistake{"OutputEmpty", "draw cube.obj -o ''", kUsage, "--output: "},
        Mistake{"NoSuffix", "draw cube.obj -o out", kUsage, "--output: \"out\" does not end in .svg, .pdf, .png, "},
        Mistake{"UnknownSuffix", "draw cube.obj -o out.dxf", kUsage, "--output: \"out.dxf\" does not end in .svg"},
        Mistake{"StandardOutputNeedsFormat", "draw cube.obj -o -", kUsage, "--output: standard output needs a"},
        Mistake{"OutputIsInput", "draw cube.obj -o ./cube.obj --format svg", kUsage,
                "--output: ./cube.obj is also an input"},
        Mistake{"OutputIsSecondInput", "draw cube.obj square.obj -o square.obj --format svg", kUsage, "--output: "},
        Mistake{"InfoOverInput", "info cube.obj -o cube.obj", kUsage, "--output: cube.obj is also an input file"},
        Mistake{"InfoFormat", "info cube.obj --format svg", kUsage, "--format: info is written as text"},
        Mistake{"MethodUnknown", "methods apel", kUsage, "methods: \"apel\" is not one of "},
        Mistake{"ModelMissing", "draw 'no such.obj' -o out.svg", kFailed, "no such.obj: "},
        Mistake{"ModelIsFolder", "draw . -o out.svg", kFailed, ".: "},
        Mistake{"PlotMissing", "plot none.svg -o out.hpgl", kFailed, "none.svg: there is no such file\n"},
        Mistake{"PlotNoDrawing", "plot cube.obj -o out.hpgl", kFailed, "cube.obj: is neither a ligne-drawing nor an SVG"},
        Mistake{"PlotFolder", "plot . -o out.hpgl", kFailed, ".: is a directory, not a file\n"},
        Mistake{"PlotAsJson", "plot cube.obj -o out.json", kUsage, "--format: plot writes svg"},
        Mistake{"PlotSkip", "plot cube.obj --skip ink -o out.svg", kUsage, "--skip: \"ink\" is not one of"},
        Mistake{"PensMissing", "draw cube.obj --pens none.toml -o out.svg", kFailed, "none.toml: there is no such file\n"},
        Mistake{"DeviceMissing", "draw cube.obj --device-file none.toml -o out.hpgl", kFailed,
                "none.toml: there is no such file\n"},
        Mistake{"SecondModelMissing", "draw cube.obj none.stl -o out.svg", kFailed, "none.stl: "},
        Mistake{"ModelBroken", "draw broken.obj -o out.svg", kFailed, "broken.obj:4: "},
        Mistake{"InfoModelMissing", "info none.obj", kFailed, "none.obj: "},
        Mistake{"FolderMissing", "draw cube.obj -o none/out.svg", kFailed, "none/out.svg: "},
        Mistake{"StatsFolderMissing", "info cube.obj -o /dev/null --stats-json none/s.json", kFailed, "none/s.json: "}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_F(ProgramTest, FailureKeepsTheEarlierDrawing) {
  write("out.svg", "earlier");
  EXPECT_EQ(run("draw broken.obj -o out.svg").status, kFailed);
  EXPECT_EQ(contents(file("out.svg")), "earlier");
}

const std::vector<Words> kWritersToStandardOutput{
    "draw cube.obj -o - --format svg", "info cube.obj", {"methods"}, {"--help"}};

TEST_F(ProgramTest, FullDeviceIsAFailure) {
  for (const Words& arguments : kWritersToStandardOutput) {
    const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
    if (full < 0) return;  // not every system has one
    const Outcome outcome = run_program(folder_, arguments, full);
    EXPECT_EQ(outcome.status, kFailed) << arguments[0];
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  }
}

TEST_F(ProgramTest, ReaderThatWentAwayIsAFailureWithoutASignal) {
  for (const Words& arguments : kWritersToStandardOutput) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
    close(ends[0]);
    const Outcome outcome = run_program(folder_, arguments, ends[1]);
    EXPECT_EQ(outcome.status, kFailed) << arguments[0];
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: ", 0), 0u) << outcome.err;
  }
}

/// The other tests call the command in their own process.
TEST_F(ProgramTest, TheProgramDoesWhatTheCommandDoes) {
  for (const Words arguments :
       {"draw cube.obj -o - --format json", "draw broken.obj -o x.svg", "draw cube.obj --crease much -o x.svg",
        "info square.obj", "surface x*y -o - --format svg --stats", "plot none.svg -o x.svg", "--version", ""}) {
    const Outcome here = run(arguments), there = run_program(folder_, arguments);
    const std::string what = arguments.empty() ? "no command" : arguments.back();
    EXPECT_EQ(here.status, there.status) << what;
    EXPECT_EQ(here.out, there.out) << what;
    if (what != "--stats") {  // times
      EXPECT_EQ(here.err, there.err) << what;
    }
  }
}

TEST_F(ProgramTest, TheCommandLeavesNoLimitAndNoHandlerBehind) {
  rlimit before{}, after{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
  const std::new_handler new_handler = std::get_new_handler();
  const std::terminate_handler terminate_handler = std::get_terminate();
  EXPECT_EQ(run("draw cube.obj --dpi 1200 --max-memory 64M -o x.png").status, kFailed);
  run_well("draw cube.obj --max-memory 500M --threads 3 -o x.svg");
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &after), 0);
  EXPECT_EQ(after.rlim_cur, before.rlim_cur);
  EXPECT_EQ(after.rlim_max, before.rlim_max);
  EXPECT_EQ(std::get_new_handler(), new_handler);
  EXPECT_EQ(std::get_terminate(), terminate_handler);
  EXPECT_EQ(run("draw cube.obj -o x.svg").err, "");
}

}  // namespace
}  // namespace ligne::test
