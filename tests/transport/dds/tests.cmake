# A process beside the tests, and the tests of the node.
add_executable(dds_peer transport/dds/peer/main.cpp)
leitstand_warnings(dds_peer)
leitstand_suppressions(dds_peer)
target_link_libraries(dds_peer PRIVATE leitstand_test_support leitstand_transport)
leitstand_test(dds_tests FOLDER transport/dds LABEL dds LIBS leitstand_transport leitstand_fastdds fastcdr fmt::fmt)
add_dependencies(dds_tests dds_peer)
