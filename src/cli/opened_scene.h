// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/reference_scene.h"
#include "cli/command_line.h"
#include "document/open_document.h"
#include "gl/context.h"
#include "mesh/coordinate_change.h"
#include "scene/scene_gpu.h"
#include "session/session.h"

namespace hitscope::cli {

/// What a verb works on.
struct SceneWish {
    QString
        path;  ///< a session (.hitscope, or - for the standard input), else a mesh; empty: the paper's scene
    /// Nothing: the session's own; of a mesh the usual one, or, where that is not exact here, one that is.
    std::optional<PipelineKind> pipeline = {};
    std::optional<std::size_t> until = {};  ///< only the first so many hits; nothing: all
    bool isMeshAlone = false;               ///< of a mesh, that is not shot at: nothing follows its hits
    bool hasPipelineOption = true;          ///< the verb has --pipeline
    bool isDrawn = false;               ///< or applied by several pipelines: takes OpenGL, and has a gpu()
    CoordinateChange coordinates = {};  ///< of a mesh, before all else
};

/// Whether that names a session, not a mesh.
[[nodiscard]] bool namesSession(const QString& path);
/// A session file, or the standard input, with its meshes; one that is missing is an error, one that has
/// changed is noted.
[[nodiscard]] Result<PreparedSession> prepareFrom(const QString& path);

/// A scene with no display: its hits are applied, and what the pipeline made of the targets has come back.
class OpenedScene {
public:
    OpenedScene() = default;
    /// Cannot draw, bad input, or good.
    [[nodiscard]] Outcome open(const SceneWish& wish);
    /// Another pipeline of a scene that is drawn; cannot draw where it does not run here.
    [[nodiscard]] Outcome use(PipelineKind kind);
    /// Likewise useAskedPipeline().
    [[nodiscard]] Outcome useAsked(std::optional<PipelineKind> asked);
    /// Waits until what was done meanwhile has come back.
    [[nodiscard]] Outcome sync();

    [[nodiscard]] Session& session() { return *m_session; }
    [[nodiscard]] const Session& session() const { return *m_session; }
    [[nodiscard]] SceneGpu& gpu() { return *m_gpu; }
    /// Where the reference stands in for another one, the other.
    [[nodiscard]] PipelineKind pipeline() const { return m_pipeline; }
    /// As the file has it; null: it is no session.
    [[nodiscard]] const SessionDocument* document() const {
        return m_prepared ? &m_prepared->document : nullptr;
    }
    /// The targets whose positions are not those that were saved; nothing: those of these hits are not known.
    [[nodiscard]] std::optional<std::vector<TargetId>> differing() const;
    [[nodiscard]] QString namesOf(const std::vector<TargetId>& targets) const;  ///< "ball, cube"
    void noteDiffering() const;

private:
    [[nodiscard]] Outcome load(const SceneWish& wish);
    [[nodiscard]] Outcome openOnGpu(const SceneWish& wish, std::unique_ptr<gl::OffscreenContext> context);
    [[nodiscard]] Outcome openWithReference(const SceneWish& wish);

    std::unique_ptr<gl::OffscreenContext> m_context;
    std::unique_ptr<Session> m_session;
    std::optional<PreparedSession> m_prepared;
    // Below the session and the context, so that they go first. One of them, or none of a mesh alone.
    std::unique_ptr<SceneGpu> m_gpu;
    std::unique_ptr<ReferenceScene> m_reference;
    PipelineKind m_pipeline = PipelineKind::TransformFeedback;
};

}  // namespace hitscope::cli
