"""Makes C++, ROS message texts and type hashes from the IDL of the messages."""
