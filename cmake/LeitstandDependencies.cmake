# Packages are found once here, as system includes; targets link what they use by name.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(GTest REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZBAR REQUIRED IMPORTED_TARGET zbar)
include(GoogleTest)

if(NOT LEITSTAND_CORE_ONLY)
    find_package(CLI11 REQUIRED)
    find_package(nlohmann_json REQUIRED)
    find_package(SQLite3 3.40 REQUIRED)
    find_package(yaml-cpp REQUIRED)
    find_package(embree 3.13 REQUIRED NAMES embree embree-3.13.5)
    find_package(OpenSSL 3 REQUIRED)
    find_package(GDAL 3 REQUIRED)
    find_package(octomap 1.9 REQUIRED)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    find_package(fastcdr REQUIRED)
    find_package(fastrtps 2.9 REQUIRED)
    # Debian's VTK Qt module links Qt 5: components are listed one by one and never include it. VTK goes
    # first and PCL must not find it again, since PCL asks for that very module.
    find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonMath CommonTransforms
        FiltersCore FiltersGeneral FiltersSources InteractionStyle IOImage RenderingAnnotation RenderingCore
        RenderingFreeType RenderingOpenGL2 glew)
    set(CMAKE_DISABLE_FIND_PACKAGE_VTK ON)
    find_package(PCL 1.13 REQUIRED COMPONENTS common kdtree search filters features registration io)
    unset(CMAKE_DISABLE_FIND_PACKAGE_VTK)
    # For a test; VTK brings them.
    pkg_check_modules(LIBAV REQUIRED IMPORTED_TARGET libavformat libavcodec libavutil libswscale)
endif()
if(NOT LEITSTAND_CORE_ONLY AND NOT LEITSTAND_FUZZ)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui)  # the printed report
endif()
if(LEITSTAND_WINDOW)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Multimedia Widgets Svg Test)
    find_package(OpenGL REQUIRED COMPONENTS EGL)
    find_package(SDL2 2.26 REQUIRED)
endif()
if(LEITSTAND_BENCHMARKS)
    find_package(benchmark REQUIRED)
    find_package(nanoflann REQUIRED)
endif()
