# SPDX-License-Identifier: GPL-3.0-or-later

# Parsing other people's headers was four fifths of the build. They are parsed once for each of these sets, which contain
# nothing of ours; a file still includes what it uses (the dev preset builds without).
#   std      the standard library and GLM
#   qt       std and Qt Core
#   widgets  qt and Qt Widgets, without anything that declares OpenGL functions (libepoxy declares its own)
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
