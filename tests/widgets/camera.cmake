# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(camera LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/camera_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(pictures LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/pictures_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(context LABEL widgets SOURCES ${CMAKE_CURRENT_LIST_DIR}/context_test.cpp LINK hitscope_app TIMEOUT 300)

# What is under the cursor is so at any scale of the screen.
foreach(scale 1.5 2)
  add_test(NAME widgets.context_at_${scale}
    COMMAND ${PROJECT_SOURCE_DIR}/tests/support/with_display $<TARGET_FILE:test_widgets_context>)
  set_tests_properties(widgets.context_at_${scale} PROPERTIES LABELS widgets TIMEOUT 300
    ENVIRONMENT "QT_SCALE_FACTOR=${scale};LIBGL_ALWAYS_SOFTWARE=1")
endforeach()
