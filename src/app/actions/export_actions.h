// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/ids.h"
#include "core/result.h"
#include "view/display_options.h"

class QAction;
class QMenu;
class QWidget;

namespace hitscope {

struct AppSettings;
class MeshExporter;
class Session;
struct Target;
class Viewport;

/// Deformed meshes into files: which, where and with which normals the person says.
class ExportActions : public QObject {
    Q_OBJECT
public:
    /// All of them outlive this; dialogs belong to `window`.
    ExportActions(Session& session, Viewport& viewport, AppSettings& settings, QWidget& window);

    void fill(QMenu& menu);  ///< once
    [[nodiscard]] QAction* exportMesh() const { return m_export; }

    /// Asks for a file, and begins to write the target in focus there.
    void choose();
    /// Begins to write the target in focus as it is on the screen, its normals too unless others are asked
    /// for.
    void begin(const QString& path, std::optional<NormalMode> normals);
    /// The same, to its end. Errors are exportTarget()'s.
    [[nodiscard]] Status write(const QString& path, std::optional<NormalMode> normals);

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);
    void began(const hitscope::Target& target, const QString& path);
    void ended(const QString& path, bool isWritten);

private:
    QString chooseOne(const Target& target);
    bool beginOf(const Target& target, const QString& path, NormalMode normals);
    void follow();

    Session& m_session;
    Viewport& m_viewport;
    AppSettings& m_settings;
    QWidget& m_window;
    MeshExporter* m_exporter;
    QAction* m_export = nullptr;
};

}  // namespace hitscope
