# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(exactness LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/exactness_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_pipeline)
