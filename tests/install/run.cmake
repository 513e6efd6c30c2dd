# run.cmake — installs the build tree under a fresh prefix, then uses what is there as a stranger would: the program, its modules, a consumer of its libraries.
#   cmake -DBUILD_DIR=.. -DSOURCE_DIR=.. -DCXX=.. -DFLAGS=.. -P run.cmake
set(root "${BUILD_DIR}/install-test")
set(prefix "${root}/prefix")
file(REMOVE_RECURSE "${root}")
file(MAKE_DIRECTORY "${root}")

# Runs a command in ${root}; its output must match `pattern`.
function(expect pattern)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${root}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nexit code ${code}\n${out}${err}")
  endif()
  if(NOT out MATCHES "${pattern}")
    message(FATAL_ERROR "${ARGN}\nsaid\n${out}\nnot\n${pattern}")
  endif()
endfunction()

expect("" "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
foreach(file bin/whittle lib/whittle/whittle_image.so lib/whittle/libcsg_eval.a include/whittle/tracer/engine/engine.h share/whittle/whittle.scad
        share/whittle/examples/carved_cube.scad share/man/man1/whittle.1 share/bash-completion/completions/whittle share/zsh/site-functions/_whittle
        share/fish/vendor_completions.d/whittle.fish lib/cmake/Whittle/WhittleConfig.cmake)
  if(NOT EXISTS "${prefix}/${file}")
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

expect("^whittle [0-9.]+" "${prefix}/bin/whittle" --version)
file(WRITE "${root}/part.scad" "difference() { cube(2, center = true); cylinder(h = 5, r = 0.5, center = true, $fn = 8); }\n")
expect("\"out\":{\"t\":4.5," "${prefix}/bin/whittle" spans part.scad --ray=-5,0,0,1,0,0 --json)
expect("" "${prefix}/bin/whittle" render part.scad -o part.tif --imgsize 16,16 --samples 1)
if(EXISTS "${BUILD_DIR}/whittle_cgal.so")
  expect("closed and oriented" "${prefix}/bin/whittle" mesh part.scad -o part.off --report)
endif()

expect("" "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${SOURCE_DIR}/tests/install/consumer" -B "${root}/consumer" "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX}"
       "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_BUILD_TYPE=Release)
expect("" "${CMAKE_COMMAND}" --build "${root}/consumer")
expect("^3 7" "${root}/consumer/consumer")
