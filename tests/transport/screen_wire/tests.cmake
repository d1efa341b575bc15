# The screen before the DDS library: real traffic passes, hostile one does not.
leitstand_test(screen_wire_tests FOLDER transport/screen_wire LABEL dds LIBS leitstand_transport leitstand_fastdds fastcdr fmt::fmt)
add_dependencies(screen_wire_tests dds_peer)
if(TARGET cyclone_peer)
    add_dependencies(screen_wire_tests cyclone_peer)
endif()
