// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/dialogs/export_dialog.h"
#include "core/ids.h"
#include "core/result.h"
#include "session/export/export_options.h"
#include "session/target_source.h"

class QAction;
class QMenu;
class QWidget;

namespace hitscope {

struct AppSettings;
class MeshExporter;
class Session;
struct Target;
class Viewport;

/// Deformed meshes into files: which, where and how the person says.
class ExportActions : public QObject {
    Q_OBJECT
public:
    /// All of them outlive this; dialogs belong to `window`.
    ExportActions(Session& session, Viewport& viewport, AppSettings& settings, QWidget& window);

    void fill(QMenu& menu);  ///< once
    [[nodiscard]] QAction* exportMesh() const { return m_export; }

    /// Asks what to write, how and to which file, and begins to.
    void choose();
    /// Begins to write the same to the same file, as it is now.
    void again();
    /// Begins to write the target in focus as it is on the screen, its normals too unless others are asked
    /// for. The suffix says the format.
    void begin(const QString& path, std::optional<NormalMode> normals);
    /// Writes a target as it is on the screen, on another thread while this one sees to all but the person's
    /// keys and clicks; what is wrong is said.
    [[nodiscard]] bool writeTarget(TargetId target, const QString& path);
    /// As begin(), to its end. Errors are exportTarget()'s.
    [[nodiscard]] Status write(const QString& path, std::optional<NormalMode> normals);

Q_SIGNALS:
    void said(const QString& text);
    void noticeWanted(const QString& text);  ///< what the file does not hold
    void failed(const hitscope::Error& error);
    void began(const std::vector<const hitscope::Target*>& targets, const QString& path);
    void writing(const QString& path);  ///< from now on; ended() follows
    void ended(const QString& path, bool isWritten);

private:
    /// A target that was written; name and source know it when its mesh was replaced.
    struct Written {
        TargetId id;
        QString name;
        TargetSource source;
    };
    /// What was written last.
    struct Last {
        QString path;
        ExportScope scope = ExportScope::OneTarget;
        std::vector<Written> targets;
        ExportOptions options;
    };
    [[nodiscard]] std::vector<const Target*> targets(ExportScope scope) const;
    [[nodiscard]] const Target* find(const Written& written) const;
    [[nodiscard]] std::vector<const Target*> lastTargets() const;
    [[nodiscard]] QString whatReplacingDoes(const QString& path) const;
    [[nodiscard]] QString choosePath(const std::vector<const Target*>& targets, ExportFormat format);
    [[nodiscard]] ExportOptions shownAs(const QString& path, std::optional<NormalMode> normals) const;
    void beginOf(const std::vector<const Target*>& targets, const QString& path,
                 const ExportOptions& options);
    void tellBegin(const std::vector<const Target*>& targets, const QString& path, ExportFormat format);
    void tellWritten(const QString& name, const QString& path, const QStringList& notes, bool wasReadBack);
    void follow();

    Session& m_session;
    Viewport& m_viewport;
    AppSettings& m_settings;
    QWidget& m_window;
    MeshExporter* m_exporter;
    QAction* m_export = nullptr;
    QAction* m_again = nullptr;
    std::optional<Last> m_last;
    QString m_handedOver;  ///< the file of the last writeTarget()
};

}  // namespace hitscope
