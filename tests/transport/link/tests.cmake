# Robots and stations as processes beside the tests, with a clock that can be wrong.
add_executable(control_peer transport/link/peer/main.cpp transport/link/peer/clock_shift.cpp
    transport/link/control_robot.cpp transport/link/control_robot.h transport/link/link_robot.cpp)
leitstand_warnings(control_peer)
leitstand_suppressions(control_peer)
set_target_properties(control_peer PROPERTIES ENABLE_EXPORTS ON)  # libraries shall find the shifted clock
target_link_libraries(control_peer PRIVATE leitstand_test_support leitstand_transport fmt::fmt)
leitstand_test(link_tests FOLDER transport/link LABEL dds LIBS leitstand_transport leitstand_fastdds fastcdr fmt::fmt)
add_dependencies(link_tests control_peer)
