# The streams of two robots over a shaped link between network namespaces.
add_executable(radio_robot transport/radio/robot/main.cpp)
leitstand_warnings(radio_robot)
leitstand_suppressions(radio_robot)
target_link_libraries(radio_robot PRIVATE leitstand_test_support leitstand_transport)
leitstand_test(radio_tests FOLDER transport/radio LABEL dds LIBS leitstand_transport fmt::fmt)
add_dependencies(radio_tests radio_robot)
