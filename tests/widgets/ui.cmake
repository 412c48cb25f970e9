# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(main_window LABEL widgets SOURCES main_window_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(viewport LABEL widgets SOURCES viewport_test.cpp LINK hitscope_app TIMEOUT 300)
hitscope_test(panels LABEL widgets SOURCES panels_test.cpp LINK hitscope_app TIMEOUT 300)
if(TARGET hitscope-import)
  add_dependencies(test_widgets_main_window hitscope-import)
endif()
hitscope_test(shortcuts LABEL widgets SOURCES shortcuts_test.cpp LINK hitscope_app TIMEOUT 300)
