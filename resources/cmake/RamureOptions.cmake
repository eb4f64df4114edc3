# Compiler, warnings, sanitizers, ccache: what every target of the project shares.
include(CTest)
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME ramure)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(RAMURE_SANITIZE "" CACHE STRING
    "address (and undefined behaviour, with the fuzz targets) or thread (document and session); needs clang (./dev check)")

set(RAMURE_OPTIMISATION -O3 CACHE STRING "of a Release build; its results are the same with any (./dev hashes)")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${CCACHE_PROGRAM})
endif()

add_library(ramure_options INTERFACE)
target_compile_options(ramure_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion
    # Of eight sources in one unit, what one has to itself is no concern of the others.
    $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
    # Clang warns of other things: it only judges the hashes.
    $<$<AND:$<NOT:$<BOOL:${RAMURE_SANITIZE}>>,$<CXX_COMPILER_ID:GNU>>:-Werror>
    # The same seed gives the same bytes on every run and machine: no contraction into fused operations.
    -ffp-contract=off -fno-math-errno
    # Nothing of this is a shared library whose functions another could replace: they may be inlined.
    -fno-semantic-interposition)
if(CCACHE_PROGRAM AND NOT RAMURE_SANITIZE)
    target_compile_options(ramure_options INTERFACE -fpch-preprocess)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    # The time of a suite goes into the program that it tests; its own code is compiled faster with less.
    target_compile_options(ramure_options INTERFACE
        $<IF:$<BOOL:$<TARGET_PROPERTY:RAMURE_IS_SUITE>>,-O1,${RAMURE_OPTIMISATION}>)
endif()
if(RAMURE_SANITIZE)
    # RAMURE_SANITIZED: the largest cases of a test may be smaller. Clang's precompiled headers and ccache: no time in them.
    add_compile_options(-fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g1 -D_GLIBCXX_ASSERTIONS -DRAMURE_SANITIZED
        "SHELL:-Xclang -fno-pch-timestamp")
endif()
if(RAMURE_SANITIZE STREQUAL "address")
    # One build of the core for suites and fuzz targets. What libFuzzer wants to know besides is left out elsewhere.
    add_compile_options(-fsanitize=address,undefined)
    add_link_options(-fsanitize=address,undefined)
elseif(RAMURE_SANITIZE STREQUAL "thread")
    add_compile_options(-fsanitize=thread)
    add_link_options(-fsanitize=thread)
elseif(RAMURE_SANITIZE)
    message(FATAL_ERROR "RAMURE_SANITIZE is address or thread, not ${RAMURE_SANITIZE}")
endif()

# Most of the time of a source goes into the headers it reads: eight read them together. What two of them name alike in
# an anonymous namespace is then an error, and often the same thing written twice.
set(CMAKE_UNITY_BUILD ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# Third-party headers never raise our warnings.
function(ramure_link_system target visibility)
    foreach(lib ${ARGN})
        target_link_libraries(${target} ${visibility} ${lib})
        get_target_property(dirs ${lib} INTERFACE_INCLUDE_DIRECTORIES)
        if(dirs)
            target_include_directories(${target} SYSTEM ${visibility} ${dirs})
        endif()
    endforeach()
endfunction()
