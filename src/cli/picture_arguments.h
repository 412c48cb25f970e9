// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/result.h"
#include "deform/pipeline_kind.h"
#include "view/display_options.h"

namespace hitscope::cli {

/// What picture and sequence have in common: the scene, and how it is seen.
struct PictureArguments {
    QString meshPath;  ///< empty: the paper's scene
    int shots = 0;
    unsigned seed = 1;
    std::optional<PipelineKind> pipeline;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
    DisplayOptions options;
    bool labels = true;  ///< the colour bar, where change is shown
    QString camera;      ///< as parseCamera() takes it; empty: all in the picture
};

/// The options of the command line for them.
class PictureOptions {
public:
    explicit PictureOptions(QCommandLineParser& parser);
    /// The error says which option is wrong; "where" is its name.
    [[nodiscard]] Result<PictureArguments> read(const QCommandLineParser& parser) const;

private:
    QCommandLineOption m_size;
    QCommandLineOption m_camera;
    QCommandLineOption m_transparent;
    QCommandLineOption m_cut;
    QCommandLineOption m_fillCut;
    QCommandLineOption m_noFloor;
    QCommandLineOption m_theme;
    QCommandLineOption m_wireframe;
    QCommandLineOption m_normals;
    QCommandLineOption m_change;
    QCommandLineOption m_noLabels;
    QCommandLineOption m_pipeline;
    QCommandLineOption m_shots;
    QCommandLineOption m_seed;
};

/// A whole number in [lowest, highest]; nothing if the text is no such thing.
[[nodiscard]] std::optional<int> wholeNumber(const QString& text, int lowest, int highest);

}  // namespace hitscope::cli
