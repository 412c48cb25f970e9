// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture_arguments.h"

#include <array>

#include "cli/cut_argument.h"
#include "cli/pipeline_argument.h"

namespace hitscope::cli {

namespace {

constexpr int kMostShots = 100'000;
constexpr int kLargestSide = 1'000'000;  // pixels; what the driver can draw is asked for later

QCommandLineOption option(const char* name, const QString& text, const char* value = nullptr,
                          const char* standard = nullptr) {
    QCommandLineOption made(QString::fromLatin1(name), text);
    if (value != nullptr) {
        made.setValueName(QString::fromLatin1(value));
    }
    if (standard != nullptr) {
        made.setDefaultValue(QString::fromLatin1(standard));
    }
    return made;
}

Error wrong(const QCommandLineOption& option, const QString& takes) {
    return {("--" + option.names().constFirst() + " takes " + takes + '.').toStdString(), "", ""};
}

/// Which of the words the option has; -1: none.
qsizetype wordOf(const QCommandLineParser& parser, const QCommandLineOption& option,
                 const QStringList& words) {
    return words.indexOf(parser.value(option));
}

const QStringList& themes() {
    static const QStringList words{QStringLiteral("light"), QStringLiteral("dark")};  // by Theme
    return words;
}

const QStringList& wireframes() {
    static const QStringList words{QStringLiteral("off"), QStringLiteral("over"),
                                   QStringLiteral("only")};  // by WireframeMode
    return words;
}

const QStringList& normalModes() {
    static const QStringList words{QStringLiteral("true"), QStringLiteral("paper")};  // by NormalMode
    return words;
}

/// By ChangeQuantity; but for the difference to a second pipeline, which is its last.
QStringList changeKeys() {
    QStringList keys;
    for (const ChangeTraits& traits : allChangeQuantities()) {
        if (traits.quantity != ChangeQuantity::Difference) {
            keys << QString::fromUtf8(traits.key);
        }
    }
    return keys;
}

QString oneOf(const QStringList& words) {
    return QStringLiteral("one of ") + words.join(QStringLiteral(", "));
}

}  // namespace

std::optional<int> wholeNumber(const QString& text, int lowest, int highest) {
    bool isNumber = false;
    const int value = text.toInt(&isNumber);
    return isNumber && value >= lowest && value <= highest ? std::optional(value) : std::nullopt;
}

PictureOptions::PictureOptions(QCommandLineParser& parser)
    : m_size(option("size", QStringLiteral("Pixels of the picture."), "WxH", "1280x720")),
      m_camera(option("camera",
                      QStringLiteral("Camera, as Edit > Copy Camera gives it: \"camera pivot 0 0 0 yaw 35 "
                                     "pitch 20 distance 12 fov 50 perspective\". Default: the whole scene."),
                      "text")),
      m_transparent(option("transparent", QStringLiteral("No background."))),
      m_cut(option(
          "cut",
          QStringLiteral("Cut the targets open: x=0.1 hides what lies beyond 0.1 m along x, -x=0.1 the "
                         "other side, 1,1,0=0.5 cuts across that direction."),
          "plane")),
      m_fillCut(option("fill-cut", QStringLiteral("Close what is cut, as if targets were solid."))),
      m_noFloor(option("no-floor", QStringLiteral("No floor."))),
      m_theme(option("theme", QStringLiteral("Background: light or dark."), "name", "dark")),
      m_wireframe(
          option("wireframe", QStringLiteral("Edges: off, over the surface, or only."), "mode", "off")),
      m_normals(option("normals", QStringLiteral("Shading: true or paper."), "kind", "true")),
      m_change(
          option("change", QStringLiteral("Colour by change: ") + oneOf(changeKeys()) + u'.', "quantity")),
      m_noLabels(option("no-labels", QStringLiteral("No colour bar in the picture."))),
      m_pipeline(option("pipeline",
                        QStringLiteral("Pipeline that applies the hits: ") + oneOf(pipelineWords()) + u'.',
                        "name", "transform-feedback")),
      m_shots(
          option("shots", QStringLiteral("Number of shots before the picture, 0 to 100000."), "number", "0")),
      m_seed(option("seed", QStringLiteral("Another seed gives other shots."), "number", "1")) {
    parser.addOptions({m_size, m_camera, m_transparent, m_cut, m_fillCut, m_noFloor, m_theme, m_wireframe,
                       m_normals, m_change, m_noLabels, m_pipeline, m_shots, m_seed});
}

Result<PictureArguments> PictureOptions::read(const QCommandLineParser& parser) const {
    PictureArguments arguments;
    const QStringList size = parser.value(m_size).split(u'x');
    const auto width = wholeNumber(size.value(0), 1, kLargestSide);
    const auto height = wholeNumber(size.value(1), 1, kLargestSide);
    if (size.size() != 2 || !width || !height) {
        return wrong(m_size, QStringLiteral("width and height in pixels, as in 1920x1080"));
    }
    arguments.width = *width;
    arguments.height = *height;
    const qsizetype theme = wordOf(parser, m_theme, themes());
    const qsizetype wireframe = wordOf(parser, m_wireframe, wireframes());
    const qsizetype normals = wordOf(parser, m_normals, normalModes());
    const std::array<std::pair<const QCommandLineOption&, QStringList>, 4> words{
        {{m_theme, themes()},
         {m_wireframe, wireframes()},
         {m_normals, normalModes()},
         {m_pipeline, pipelineWords()}}};
    for (const auto& word : words) {
        if (wordOf(parser, word.first, word.second) < 0) {
            return wrong(word.first, oneOf(word.second));
        }
    }
    arguments.options.theme = static_cast<Theme>(theme);
    arguments.options.wireframe = static_cast<WireframeMode>(wireframe);
    arguments.options.normals = static_cast<NormalMode>(normals);
    if (parser.isSet(m_pipeline)) {
        arguments.pipeline = pipelineNamed(parser.value(m_pipeline));
    }
    arguments.options.transparent = parser.isSet(m_transparent);
    arguments.options.floor = !parser.isSet(m_noFloor);
    arguments.labels = !parser.isSet(m_noLabels);
    if (parser.isSet(m_change)) {
        const qsizetype change = wordOf(parser, m_change, changeKeys());
        if (change < 0) {
            return wrong(m_change, oneOf(changeKeys()));
        }
        arguments.options.change.on = true;
        arguments.options.change.quantity = allChangeQuantities()[static_cast<std::size_t>(change)].quantity;
    }
    if (parser.isSet(m_cut)) {
        const std::optional<CuttingPlane> cut = parseCut(parser.value(m_cut));
        if (!cut) {
            return wrong(m_cut,
                         QStringLiteral("an axis or a direction, and metres, as in x=0.1 or 1,1,0=0.5"));
        }
        arguments.options.cut = *cut;
        arguments.options.cut.fill = parser.isSet(m_fillCut);
    }
    const auto shots = wholeNumber(parser.value(m_shots), 0, kMostShots);
    bool seedOk = false;
    arguments.seed = parser.value(m_seed).toUInt(&seedOk);
    if (!shots || !seedOk) {
        return shots ? wrong(m_seed, QStringLiteral("a whole number, 0 or more"))
                     : wrong(m_shots, QStringLiteral("a whole number from 0 to %1").arg(kMostShots));
    }
    arguments.shots = *shots;
    arguments.camera = parser.value(m_camera);
    return arguments;
}

}  // namespace hitscope::cli
