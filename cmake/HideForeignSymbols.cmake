# hide_foreign_symbols(TARGET): a shared library exports what is in namespace ligne, and nothing of the libraries of templates and the
# parsers that are compiled into it, so that a program may hold other versions of these. The linkers of ELF systems can do that.
include(CheckLinkerFlag)
function(hide_foreign_symbols target)
  set(script ${PROJECT_SOURCE_DIR}/package/ligne.map)
  check_linker_flag(CXX -Wl,--version-script=${script} LIGNE_HAVE_VERSION_SCRIPT)
  if(LIGNE_HAVE_VERSION_SCRIPT)
    target_link_options(${target} PRIVATE -Wl,--version-script=${script})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
  endif()
endfunction()
