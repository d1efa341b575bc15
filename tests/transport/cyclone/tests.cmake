# Cyclone DDS as a peer that shares nothing with us but the IDL: its own generator, its own encoder; and as a stock
# robot.
set(cyclone_dir ${CMAKE_CURRENT_SOURCE_DIR}/transport/cyclone)
set(cyclone_out ${CMAKE_CURRENT_BINARY_DIR}/cyclone)
set(idl_dir ${CMAKE_SOURCE_DIR}/transport/idl)
file(GLOB idl_files CONFIGURE_DEPENDS ${idl_dir}/*.idl)
file(GLOB idl_generator CONFIGURE_DEPENDS ${idl_dir}/generator/*.py)
add_custom_command(OUTPUT ${cyclone_out}/peer_types.c ${cyclone_out}/our_types.cpp
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE}
        ${cyclone_dir}/generate_fill.py ${cyclone_out} ${idl_dir} ${idl_files}
    DEPENDS ${idl_files} ${idl_generator} ${cyclone_dir}/generate_fill.py
    COMMENT "Making code that fills every message" VERBATIM)

leitstand_test(cyclone_tests FOLDER transport/cyclone LABEL dds LIBS leitstand_transport fmt::fmt)
target_sources(cyclone_tests PRIVATE ${cyclone_out}/our_types.cpp)

find_package(CycloneDDS 0.10 QUIET)
find_program(IDLC idlc)
if(TARGET CycloneDDS::ddsc AND IDLC)
    set(idlc_code)
    foreach(idl ${idl_files})
        cmake_path(GET idl STEM package)
        add_custom_command(OUTPUT ${cyclone_out}/${package}.c ${cyclone_out}/${package}.h
            COMMAND ${IDLC} -l c -x final -o ${cyclone_out} ${idl}
            DEPENDS ${idl_files} COMMENT "idlc ${package}" VERBATIM)
        list(APPEND idlc_code ${cyclone_out}/${package}.c ${cyclone_out}/${package}.h)
    endforeach()
    add_library(cyclone_messages STATIC ${idlc_code})
    target_link_libraries(cyclone_messages PUBLIC CycloneDDS::ddsc)
    target_include_directories(cyclone_messages PUBLIC ${cyclone_out})
    add_executable(cyclone_peer ${cyclone_dir}/peer/main.c ${cyclone_out}/peer_types.c)
    target_include_directories(cyclone_peer PRIVATE ${cyclone_dir}/peer)
    add_executable(cyclone_robot ${cyclone_dir}/robot/main.c)
    target_link_libraries(cyclone_robot PRIVATE m)
    # A service, whose messages are laid out otherwise than ours.
    add_custom_command(OUTPUT ${cyclone_out}/service/std_srvs.c ${cyclone_out}/service/std_srvs.h
        COMMAND ${CMAKE_COMMAND} -E make_directory ${cyclone_out}/service
        COMMAND ${IDLC} -l c -x final -o ${cyclone_out}/service ${cyclone_dir}/service/std_srvs.idl
        DEPENDS ${cyclone_dir}/service/std_srvs.idl COMMENT "idlc std_srvs" VERBATIM)
    add_executable(cyclone_service ${cyclone_dir}/service/main.c ${cyclone_out}/service/std_srvs.c
        ${cyclone_out}/service/std_srvs.h)
    target_include_directories(cyclone_service PRIVATE ${cyclone_out}/service)
    foreach(program cyclone_peer cyclone_robot cyclone_service)
        set_target_properties(${program} PROPERTIES C_STANDARD 11)
        target_compile_options(${program} PRIVATE -Wall)
        target_link_libraries(${program} PRIVATE cyclone_messages)
    endforeach()
    add_dependencies(cyclone_tests cyclone_peer cyclone_service)
else()
    message(WARNING "Cyclone DDS was not found: the tests against it will be skipped")
endif()
