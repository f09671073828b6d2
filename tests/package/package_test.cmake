# Installs the build, moves the prefix, and builds and tests docs/examples against it as a user
# would. Detects files missing from the package and paths tied to the build folder.
#   cmake -D SOURCE=<source dir> -D BUILD=<build dir> -D CONFIG=<config> -D CXX=<compiler>
#         -D WORK=<scratch dir> -P package_test.cmake
cmake_minimum_required(VERSION 3.24)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
file(RENAME ${WORK}/installed ${WORK}/prefix)

run(${CMAKE_COMMAND} -S ${SOURCE}/docs/examples -B ${WORK}/build -G Ninja
  -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --output-on-failure --no-tests=error)

# The installed program finds its catalogue and its engines relative to itself.
run(${WORK}/prefix/bin/touchstone list contact/box_box)
run(${WORK}/prefix/bin/touchstone oracles)
