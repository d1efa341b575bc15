# Packages are found once here, as system includes; targets link what they use by name.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
if(LEITSTAND_TESTS)
    find_package(GTest REQUIRED)
    include(GoogleTest)
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)  # makes sources, and parts them into units
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZBAR REQUIRED IMPORTED_TARGET zbar)
find_package(ZLIB REQUIRED)
pkg_check_modules(LIBAV REQUIRED IMPORTED_TARGET libavcodec libavutil libswscale)  # videos of robots; VTK brings them

if(NOT LEITSTAND_CORE_ONLY)
    find_package(CLI11 REQUIRED)
    find_package(nlohmann_json REQUIRED)
    find_package(SQLite3 3.40 REQUIRED)
    find_package(yaml-cpp REQUIRED)
    find_package(tinyxml2 REQUIRED)
    find_package(assimp REQUIRED)  # meshes of robots' models
    pkg_check_modules(QRENCODE REQUIRED IMPORTED_TARGET libqrencode)
    # Debian 12 has Embree 3, Debian 13 Embree 4: robots/simulation/scene/embree.h.
    find_package(embree 4 QUIET NAMES embree)
    if(NOT embree_FOUND)
        find_package(embree 3.13 REQUIRED NAMES embree embree-3.13.5)
    endif()
    find_package(OpenSSL 3 REQUIRED)
    if(LEITSTAND_TESTS OR LEITSTAND_BENCHMARKS)
        find_package(Ceres 2.1 REQUIRED)  # a peer to measure against
    endif()
    find_package(GDAL 3 REQUIRED)
    find_package(octomap 1.9 REQUIRED)
    find_package(fastcdr REQUIRED)
    # Debian 12 has Fast DDS 2.9, named after its protocol, Debian 13 Fast DDS 3: transport/dds/detail/fastdds.h.
    add_library(leitstand_fastdds INTERFACE)
    find_package(fastdds 3 QUIET)
    if(fastdds_FOUND)
        target_link_libraries(leitstand_fastdds INTERFACE fastdds)
        # What it asks of those who link it, for all: headers that are read once must be read alike.
        add_compile_definitions(_FILE_OFFSET_BITS=64)
    else()
        find_package(fastrtps 2.9 REQUIRED)
        target_link_libraries(leitstand_fastdds INTERFACE fastrtps)
    endif()
    # Debian's VTK Qt module links Qt 5: components are listed one by one and never include it. VTK goes
    # first and PCL must not find it again, since PCL asks for that very module.
    find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonMath CommonTransforms
        FiltersCore FiltersGeneral FiltersSources InteractionStyle IOImage RenderingAnnotation RenderingCore
        RenderingFreeType RenderingOpenGL2 glew)
    find_package(BZip2 REQUIRED)  # of chunks in bags of ROS 1
    pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)  # its checksums
    pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)    # of chunks in MCAP bags
    pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)  # likewise, and of messages in bags
    pkg_check_modules(LZF REQUIRED IMPORTED_TARGET liblzf)  # of compressed PCD files
    if(LEITSTAND_TESTS)
        # Our peer in benchmarks, and a reader of what we write.
        set(CMAKE_DISABLE_FIND_PACKAGE_VTK ON)
        find_package(PCL 1.13 REQUIRED COMPONENTS common kdtree search filters features registration io)
        unset(CMAKE_DISABLE_FIND_PACKAGE_VTK)
        # PCL 1.15 has all who link it compiled with OpenMP, 1.13 nobody. Headers that are read once must be read alike.
        if(TARGET OpenMP::OpenMP_CXX)
            set_property(TARGET OpenMP::OpenMP_CXX PROPERTY INTERFACE_COMPILE_OPTIONS)
        endif()
        pkg_check_modules(LIBAVFORMAT REQUIRED IMPORTED_TARGET libavformat)  # for a test of films
    endif()
endif()
if(NOT LEITSTAND_CORE_ONLY AND NOT LEITSTAND_FUZZ)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui)  # the printed report
endif()
if(LEITSTAND_WINDOW)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Multimedia Widgets Svg)
    if(LEITSTAND_TESTS)
        find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
    endif()
    find_package(OpenGL REQUIRED COMPONENTS EGL)
    find_package(SDL2 2.26 REQUIRED)
endif()
if(LEITSTAND_BENCHMARKS)
    find_package(benchmark REQUIRED)
    find_package(nanoflann REQUIRED)
endif()
