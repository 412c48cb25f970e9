# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(cut LABEL render
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/cut_test.cpp ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp
  LINK hitscope_render Qt6::Gui)
