# What every target of ours has in common: C++20, warnings as errors, sanitizers, ccache, bin/.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1  # another checkout's results count too
        ${CCACHE_PROGRAM})
endif()
set(CMAKE_PCH_INSTANTIATE_TEMPLATES ON)

# A build from nothing takes half the time; after a change more is compiled than with a unit of each file.
option(LEITSTAND_UNITY "Compile a target's files a dozen at a time" OFF)
set(CMAKE_UNITY_BUILD ${LEITSTAND_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)

if(LEITSTAND_SANITIZE)
    add_compile_options(-fsanitize=${LEITSTAND_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -O1 -g1)
    add_link_options(-fsanitize=${LEITSTAND_SANITIZE})
endif()

# Files whose names of their own are also those of others in their target.
file(STRINGS ${CMAKE_SOURCE_DIR}/cmake/compiled-alone.txt alone REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/cmake/compiled-alone.txt)
list(TRANSFORM alone PREPEND ${CMAKE_SOURCE_DIR}/)

function(leitstand_warnings target)
    set_source_files_properties(${alone} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    # GCC's word counts; clang, which builds the fuzz targets, warns of other things.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wall -Wextra -Wconversion -Werror>)
    target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR})
endfunction()

# leitstand_precompile(target HEADERS...): only where many units share heavy headers.
function(leitstand_precompile target)
    if(LEITSTAND_UNITY)
        return()  # a dozen files share one reading of them already
    endif()
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)  # for ccache
    target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

# leitstand_library(name FOLDERS a b ... [PUBLIC libs] [PRIVATE libs] [QT])
# Takes every .cpp and .h of the folders.
function(leitstand_library name)
    cmake_parse_arguments(ARG "QT" "" "FOLDERS;PUBLIC;PRIVATE" ${ARGN})
    set(sources)
    foreach(folder ${ARG_FOLDERS})
        file(GLOB found CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
        list(APPEND sources ${found})
    endforeach()
    add_library(${name} STATIC ${sources})
    leitstand_warnings(${name})
    target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    if(ARG_QT)
        set_target_properties(${name} PROPERTIES AUTOMOC ON)
    endif()
endfunction()
