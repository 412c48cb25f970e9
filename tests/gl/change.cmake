# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(change_map LABEL gl
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/change_map_test.cpp ${CMAKE_CURRENT_LIST_DIR}/../support/gl_fixture.cpp
  LINK hitscope_session)
