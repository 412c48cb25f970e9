# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(vertex_selection LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/vertex_selection_test.cpp LINK hitscope_session)
