# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(session_targets LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/session_targets_test.cpp LINK hitscope_session)
