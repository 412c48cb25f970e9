# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(scene_sections LABEL models SOURCES ${CMAKE_CURRENT_LIST_DIR}/scene_sections_test.cpp LINK hitscope_models)
