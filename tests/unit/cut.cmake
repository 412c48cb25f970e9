# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(section_view LABEL unit SOURCES ${CMAKE_CURRENT_LIST_DIR}/section_view_test.cpp
  LINK hitscope_render hitscope_mesh)
