# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(shaders LABEL gl SOURCES shaders_test.cpp ../support/gl_fixture.cpp LINK hitscope_gl)
target_compile_definitions(test_gl_shaders PRIVATE HITSCOPE_SHADERS="${PROJECT_SOURCE_DIR}/shaders")

foreach(test agreement deform_shader history_edits pipelines uniform_array)
  hitscope_test(${test} LABEL gl
    SOURCES ${test}_test.cpp pipeline_support.cpp ../support/gl_fixture.cpp
    LINK hitscope_pipeline)
endforeach()
