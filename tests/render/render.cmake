# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(renderer LABEL render
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/renderer_test.cpp ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp
  LINK hitscope_render Qt6::Gui)

hitscope_test(wireframe LABEL render
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/wireframe_test.cpp ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp
  LINK hitscope_render Qt6::Gui)

# Writes the pictures that lights and colours were chosen by: render_pictures FOLDER.
add_executable(render_pictures ${CMAKE_CURRENT_LIST_DIR}/render_pictures.cpp
  ${CMAKE_CURRENT_LIST_DIR}/render_support.cpp)
target_link_libraries(render_pictures PRIVATE hitscope_render Qt6::Gui hitscope_options)
target_include_directories(render_pictures PRIVATE ${PROJECT_SOURCE_DIR}/tests)
