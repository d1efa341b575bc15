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
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_CURRENT_LIST_DIR}/compile ${CMAKE_SOURCE_DIR})
endif()
set(CMAKE_PCH_INSTANTIATE_TEMPLATES ON)

# A build from nothing reads headers once a batch; after a change more is compiled than with a unit of each file.
option(LEITSTAND_UNITY "Compile a target's files a dozen at a time" OFF)
set(CMAKE_UNITY_BUILD ${LEITSTAND_UNITY})

if(LEITSTAND_SANITIZE)
    add_compile_options(-fsanitize=${LEITSTAND_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -O1 -g1)
    add_link_options(-fsanitize=${LEITSTAND_SANITIZE})
    # Under AddressSanitizer Eigen does not trust malloc to align by 16 bytes; the libraries that hand us memory of
    # Eigen's (PCL, Ceres) were built to trust it, and each side frees what the other took.
    add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()

# leitstand_headers(name LIBS libs... HEADERS headers... [PROGRAMS]): headers of others that are read once for all
# targets which take them, by leitstand_warnings(target name): libraries, or programs with PROGRAMS, since the two are
# compiled with different flags (programs that link Qt as libraries). Only with LEITSTAND_UNITY: those are builds of everything.
function(leitstand_headers name)
    cmake_parse_arguments(ARG "PROGRAMS" "" "LIBS;HEADERS" ${ARGN})
    if(LEITSTAND_UNITY)
        file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.cpp CONTENT "")
        add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/${name}.cpp)
        target_link_libraries(${name} PRIVATE ${ARG_LIBS})
        target_compile_options(${name} PRIVATE -fpch-preprocess)
        if(ARG_PROGRAMS)
            set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
            target_compile_options(${name} PRIVATE -fPIE)
        endif()
        target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
    endif()
endfunction()
set(standard_headers <algorithm> <array> <atomic> <chrono> <cmath> <deque> <filesystem> <functional> <map> <memory>
    <mutex> <optional> <set> <span> <stop_token> <string> <string_view> <thread> <utility> <variant> <vector>
    <Eigen/Core> <Eigen/Geometry>)
set(window_headers <QAction> <QApplication> <QBoxLayout> <QLabel> <QMainWindow> <QPainter> <QTableView> <QToolButton>
    <QWidget>)

# leitstand_groups(target): which of its files are compiled as one unit; a file in no group is compiled alone.
function(leitstand_groups target)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    if(NOT LEITSTAND_UNITY OR NOT sources)
        return()
    endif()
    list(TRANSFORM sources REPLACE "^([^/].*)$" "${CMAKE_CURRENT_SOURCE_DIR}/\\1")
    list(FILTER sources INCLUDE REGEX "^${CMAKE_SOURCE_DIR}/")
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_BINARY_DIR}/")
    execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/cmake/unity_groups.py ${CMAKE_SOURCE_DIR}
        ${CMAKE_BINARY_DIR}/unity_names.json ${target} ${sources} OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[^\n]+" groups "${groups}")
    while(groups)
        list(POP_FRONT groups source group)
        set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group})
    endwhile()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# leitstand_warnings(target [headers]): what each target of ours has.
function(leitstand_warnings target)
    get_target_property(type ${target} TYPE)
    set(headers ${ARGN})
    if(NOT headers AND type STREQUAL "STATIC_LIBRARY")
        set(headers leitstand_headers)
    endif()
    if(headers AND TARGET ${headers})
        target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
        target_precompile_headers(${target} REUSE_FROM ${headers})
    endif()
    leitstand_groups(${target})
    # GCC's word counts; clang, which builds the fuzz targets, warns of other things.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wall -Wextra -Wconversion -Werror>)
    if(LEITSTAND_UNITY)  # there each file looks like a header, whose unnamed namespaces others might see
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
    target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR})
endfunction()

# leitstand_precompile(target HEADERS...): only where many units share heavy headers.
function(leitstand_precompile target)
    if(LEITSTAND_UNITY)
        return()  # see leitstand_headers
    endif()
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)  # for ccache
    target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

# leitstand_library(name FOLDERS a b ... [EXCEPT folder] [PUBLIC libs] [PRIVATE libs] [HEADERS headers] [QT])
# Takes every .cpp and .h of the folders; a/** with those below, ** all here and below but EXCEPT's.
function(leitstand_library name)
    cmake_parse_arguments(ARG "QT" "HEADERS;EXCEPT" "FOLDERS;PUBLIC;PRIVATE" ${ARGN})
    set(sources)
    foreach(folder ${ARG_FOLDERS})
        if(folder MATCHES "^(.*/)?\\*\\*$")
            file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_MATCH_1}*.cpp ${CMAKE_MATCH_1}*.h)
        else()
            file(GLOB found CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
        endif()
        if(ARG_EXCEPT)
            list(FILTER found EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${ARG_EXCEPT}/")
        endif()
        list(APPEND sources ${found})
    endforeach()
    add_library(${name} STATIC ${sources})
    leitstand_warnings(${name} ${ARG_HEADERS})
    target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    if(ARG_QT)
        set_target_properties(${name} PROPERTIES AUTOMOC ON)
    endif()
endfunction()

# What libraries do is not ours to check by the sanitizers, and some of them fail them. For programs.
function(leitstand_suppressions target)
    set(folder ${CMAKE_SOURCE_DIR}/tests/support/sanitizers)
    if(LEITSTAND_SANITIZE MATCHES address)
        target_sources(${target} PRIVATE ${folder}/lsan_suppressions.cpp)
    endif()
    if(LEITSTAND_SANITIZE MATCHES thread)
        set(own ${folder}/tsan_own.map)
        target_sources(${target} PRIVATE ${folder}/tsan_suppressions.cpp)
        target_link_options(${target} PRIVATE -Wl,--version-script=${own})
        set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${own})
    endif()
endfunction()
