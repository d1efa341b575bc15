# The Debian packages: cpack, in a build of preset package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME leitstand)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Leitstand authors")
set(CPACK_PACKAGE_CONTACT "The Leitstand authors <maintainers@leitstand.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL tools)
if(TARGET leitstand)
    list(APPEND CPACK_COMPONENTS_ALL window)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE architecture OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)

# Files of both match leitstand_*.deb, so that one command installs both.
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME leitstand-tools)
set(CPACK_DEBIAN_TOOLS_FILE_NAME leitstand_tools_${PROJECT_VERSION}_${architecture}.deb)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
# Loaded or read at run time, so that no library's dependencies tell of it: the platform that draws reports without a
# display, the fonts of their three languages, the words of Qt's own.
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "qt6-qpa-plugins, fonts-dejavu-core, fonts-vlgothic, gdal-data, proj-data")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "leitstand")
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "operator station for rescue robots - tools and simulation
Leitstand hears any ROS 2 robot over DDS with nothing to install on it, keeps
everything it says, and registers its 3D scans into one map.

This package has leitstandctl, which records, registers, replays and reports
missions without a display, the simulated robots of leitstand-robot, and what
all programs share: robots' descriptions, rules of scores, a sample mission.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/deb/conffiles
    ${CMAKE_SOURCE_DIR}/packaging/deb/postinst)

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME leitstand)
set(CPACK_DEBIAN_WINDOW_FILE_NAME leitstand_${PROJECT_VERSION}_${architecture}.deb)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "leitstand-tools (= ${PROJECT_VERSION}), qt6-qpa-plugins, libgl1-mesa-dri, \
libqt6svg6, qt6-translations-l10n, fonts-dejavu-core, fonts-vlgothic")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "qt6-wayland")
set(CPACK_DEBIAN_WINDOW_DESCRIPTION "operator station for rescue robots
Leitstand hears any ROS 2 robot over DDS with nothing to install on it, keeps
everything it says, and registers its 3D scans into one map with floor, walls
and ceiling told apart. The map is shown while it grows; a recorded mission
plays to and fro. One person drives a team of robots with it, simulated ones
too.

This package has the station's window.")
include(CPack)
