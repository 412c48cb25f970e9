# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(frames LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/frames_test.cpp LINK hitscope_session)
hitscope_test(cost_curves LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/cost_curves_test.cpp LINK hitscope_session)
hitscope_test(section LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/section_test.cpp LINK hitscope_mesh)
