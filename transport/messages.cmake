# Code for the messages from their IDL: leitstand_add_messages(target) gives it to a target of this folder.
file(GLOB messages_idl CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/idl/*.idl)
file(GLOB messages_generator CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/idl/generator/*.py)
set(LEITSTAND_MESSAGES_DIR ${CMAKE_CURRENT_BINARY_DIR}/generated)
set(messages_code ${LEITSTAND_MESSAGES_DIR}/messages/message_table.cpp)
foreach(idl ${messages_idl})
    cmake_path(GET idl STEM package)
    list(APPEND messages_code ${LEITSTAND_MESSAGES_DIR}/messages/${package}.h
        ${LEITSTAND_MESSAGES_DIR}/messages/${package}.cpp)
endforeach()
add_custom_command(OUTPUT ${messages_code}
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${Python3_EXECUTABLE}
        ${CMAKE_CURRENT_SOURCE_DIR}/idl/generate.py ${LEITSTAND_MESSAGES_DIR} ${messages_idl}
    DEPENDS ${messages_idl} ${messages_generator} ${CMAKE_CURRENT_SOURCE_DIR}/idl/generate.py
    COMMENT "Making the messages' code from their IDL" VERBATIM)
add_custom_target(leitstand_messages DEPENDS ${messages_code})

function(leitstand_add_messages target)
    target_sources(${target} PRIVATE ${messages_code})
    target_include_directories(${target} PUBLIC ${LEITSTAND_MESSAGES_DIR})
    add_dependencies(${target} leitstand_messages)
endfunction()
