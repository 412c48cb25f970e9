// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// A quarter of the machine's memory, 2 GiB at most: bytes.
[[nodiscard]] std::uint64_t usualImportMemory();

/// Bounds on the child process that parses the file.
struct ImportLimits {
    int seconds = 120;  ///< wall clock and CPU time
    /// What it writes to, be that memory or the file it answers in; the mesh's file does not count.
    std::uint64_t memoryBytes = usualImportMemory();
};

/// File name patterns of the formats that can be opened, for dialogs: {"OBJ (*.obj)", ...}.
[[nodiscard]] QStringList importNameFilters();
/// Lower-case suffixes without the dot: {"obj", "ply", ...}.
[[nodiscard]] QStringList importSuffixes();

/// Reads one mesh file in a child process (hitscope-import), since the libraries that parse some formats
/// crash and hang on broken files. The child's answer is checked as untrusted input. Emits finished() or
/// failed() exactly once, from the event loop; destroying the object cancels, and waits for nothing.
class MeshImport : public QObject {
    Q_OBJECT
public:
    explicit MeshImport(QString path, ImportLimits limits = {}, QObject* parent = nullptr);
    ~MeshImport() override;

    void start();
    void cancel();
    [[nodiscard]] QString path() const { return m_path; }

Q_SIGNALS:
    /// fraction in [0, 1]; negative: not known.
    void progressed(double fraction, const QString& doing);
    void finished(const std::shared_ptr<hitscope::ImportedMesh>& mesh);
    /// error.what is "cancelled" wording when cancel() was called.
    void failed(const hitscope::Error& error);

private:
    struct Private;
    QString m_path;
    std::unique_ptr<Private> d;
};

/// The same, waiting: for the command line and tests. Needs a QCoreApplication. `told`: its progressed().
/// Throws GivenUp where the thread's GiveUpScope says so.
[[nodiscard]] Result<ImportedMesh> importMesh(const QString& path, const ImportLimits& limits = {},
                                              const std::function<void(double)>& told = {});

/// Where the worker program is; set by tests, else found beside the executable and in its build folder.
void setImportWorkerPath(const QString& path);

}  // namespace hitscope
