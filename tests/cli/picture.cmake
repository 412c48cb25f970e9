# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(picture LABEL cli SOURCES ${CMAKE_CURRENT_LIST_DIR}/picture_test.cpp LINK hitscope_io Qt6::Gui)
set_property(TEST cli.picture APPEND PROPERTY ENVIRONMENT "HITSCOPE_CLI=$<TARGET_FILE:hitscope-cli>")
