# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(shoot LABEL cli SOURCES ${CMAKE_CURRENT_LIST_DIR}/shoot_test.cpp LINK Qt6::Core)
set_property(TEST cli.shoot APPEND PROPERTY ENVIRONMENT "HITSCOPE_CLI=$<TARGET_FILE:hitscope-cli>")
