# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(picking LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/picking_test.cpp LINK hitscope_session hitscope_gl)
