# Installs the build, moves the prefix, and uses the package as its users do. Detects files
# missing from the package, paths tied to the build folder, and headers or libraries that work
# under the options of this build only.
#   cmake -D SOURCE=<source dir> -D BUILD=<build dir> -D CONFIG=<config> -D CXX=<compiler>
#         -D WORK=<scratch dir> -P package_test.cmake
cmake_minimum_required(VERSION 3.24)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# build_and_test(<name> <folder> <option>...): configures, builds and tests a user's project.
function(build_and_test name folder)
  run(${CMAKE_COMMAND} -S ${folder} -B ${WORK}/${name} -G Ninja
    -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${CXX}
    -D CMAKE_PREFIX_PATH=${WORK}/prefix ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${name})
  run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/${name} --output-on-failure --no-tests=error)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
file(RENAME ${WORK}/installed ${WORK}/prefix)

build_and_test(examples ${SOURCE}/docs/examples)
# With wider vectors than the libraries were compiled for, Eigen would align its types
# otherwise than they do.
build_and_test(examples_native ${SOURCE}/docs/examples -D CMAKE_CXX_FLAGS=-march=native)
build_and_test(headers ${SOURCE}/tests/package/headers)

# The installed program finds its catalogue and its engines relative to itself.
run(${WORK}/prefix/bin/touchstone list contact/box_box)
run(${WORK}/prefix/bin/touchstone oracles)
