# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(scene_draw LABEL gl SOURCES ${CMAKE_CURRENT_LIST_DIR}/scene_draw_test.cpp LINK hitscope_session)
