# SPDX-License-Identifier: GPL-3.0-or-later

# Parsing other people's headers was four fifths of the build. They are parsed once for each of these sets, which contain
# nothing of ours; a file still includes what it uses (the dev preset builds without).
#   std      the standard library and GLM
#   qt       std and Qt Core
#   widgets  qt and Qt Widgets, without anything that declares OpenGL functions (libepoxy declares its own)
#   tests    qt and Qt Test; window_tests: with what Qt Test has for widgets
set(HITSCOPE_PRECOMPILED_std
  <algorithm> <array> <bit> <cmath> <cstdint> <cstring> <functional> <limits> <map> <memory> <mutex> <numeric> <optional>
  <random> <set> <span> <string> <string_view> <thread> <unordered_map> <utility> <variant> <vector>
  <glm/geometric.hpp> <glm/gtc/matrix_transform.hpp> <glm/gtc/quaternion.hpp> <glm/mat4x4.hpp> <glm/vec2.hpp> <glm/vec3.hpp>
  <glm/vec4.hpp>)
set(HITSCOPE_PRECOMPILED_qt ${HITSCOPE_PRECOMPILED_std}
  <QAbstractItemModel> <QByteArray> <QCoreApplication> <QDir> <QFile> <QFileInfo> <QJsonArray> <QJsonDocument> <QJsonObject>
  <QLocale> <QMap> <QObject> <QPointer> <QSettings> <QString> <QStringList> <QTextStream> <QThreadPool> <QTimer> <QVariant>)
set(HITSCOPE_PRECOMPILED_widgets ${HITSCOPE_PRECOMPILED_qt}
  <QAction> <QApplication> <QBoxLayout> <QComboBox> <QDialog> <QDockWidget> <QDoubleSpinBox> <QHeaderView> <QLabel>
  <QMainWindow> <QMenu> <QMouseEvent> <QPainter> <QPushButton> <QStyledItemDelegate> <QTableView> <QToolButton> <QWidget>)
set(HITSCOPE_PRECOMPILED_tests ${HITSCOPE_PRECOMPILED_qt} <QSignalSpy> <QTemporaryDir> <QTest>)
# Nearly all of these are about a session: who changes it builds them again anyway.
set(HITSCOPE_PRECOMPILED_window_tests ${HITSCOPE_PRECOMPILED_tests} <random> <QApplication>
  ${PROJECT_SOURCE_DIR}/src/session/session.h)

file(WRITE ${CMAKE_BINARY_DIR}/precompiled/empty.cpp.new "")
file(COPY_FILE ${CMAKE_BINARY_DIR}/precompiled/empty.cpp.new ${CMAKE_BINARY_DIR}/precompiled/empty.cpp ONLY_IF_DIFFERENT)
function(hitscope_precompile_set name)
  add_library(hitscope_precompiled_${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled/empty.cpp)
  target_link_libraries(hitscope_precompiled_${name} PRIVATE hitscope_options ${ARGN})
  target_precompile_headers(hitscope_precompiled_${name} PRIVATE ${HITSCOPE_PRECOMPILED_${name}})
endfunction()
hitscope_precompile_set(std glm::glm)
hitscope_precompile_set(qt glm::glm Qt6::Core)
hitscope_precompile_set(widgets glm::glm Qt6::Widgets)
if(BUILD_TESTING)
  # Tests are built more often than they are run, so -O1. Qt tells each of its own folders, for QTEST_MAIN alone; what is
  # precompiled must be the same for all.
  add_library(hitscope_test_options INTERFACE)
  target_compile_options(hitscope_test_options INTERFACE
    $<$<CONFIG:Release>:-O1> -UQT_TESTCASE_BUILDDIR -UQT_TESTCASE_SOURCEDIR)
  hitscope_precompile_set(tests glm::glm Qt6::Gui Qt6::Test)
  hitscope_precompile_set(window_tests glm::glm Qt6::Widgets Qt6::Test)
  foreach(set tests window_tests)
    target_link_libraries(hitscope_precompiled_${set} PRIVATE hitscope_test_options)
  endforeach()
endif()
