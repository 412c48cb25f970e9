# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(info_renderer LABEL cli SOURCES ${CMAKE_CURRENT_LIST_DIR}/info_renderer_test.cpp LINK Qt6::Core)
set_property(TEST cli.info_renderer APPEND PROPERTY ENVIRONMENT "HITSCOPE_CLI=$<TARGET_FILE:hitscope-cli>")
