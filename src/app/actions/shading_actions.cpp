// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/shading_actions.h"

#include <QAction>
#include <QMenu>
#include <array>

#include "panels/help/help_text.h"

namespace hitscope {

std::span<const ShadingSwitch> shadingSwitches() {
    static constexpr std::array<ShadingSwitch, 9> kSwitches{
        {{"shadows", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Soft &Shadows"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Of the directional light; measurements are without"),
          "Shift+S", &DisplayOptions::shadows, true},
         {"vertexColours", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Vertex &Colours"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Of meshes whose file has some"), "Shift+C",
          &DisplayOptions::vertexColours, true},
         {"flat", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Flat"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions", "One normal for each triangle, instead of smooth"),
          "Shift+L", &DisplayOptions::flat, false},
         {"backFaces", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Back Faces in Red"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Tints faces that turn their back to the eye"),
          "Shift+R", &DisplayOptions::backFaces, false},
         {"needles", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Normals as Needles"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions",
                            "Those that shade, for as many vertices as can be told apart"),
          "Shift+N", &DisplayOptions::needles, false},
         {"dots", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Vertices as Dots"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Where they are far enough apart in the picture"),
          "Shift+D", &DisplayOptions::dots, false},
         {"environment", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Environment Light"),
          QT_TRANSLATE_NOOP("hitscope::ShadingActions",
                            "A studio with soft lights instead of the session's lights"),
          "Shift+E", &DisplayOptions::environment, false},
         {"refine", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "&Refine at Rest"),
          QT_TRANSLATE_NOOP(
              "hitscope::ShadingActions",
              "While nothing moves: smooth edges, soft shadows and ambient occlusion; colour maps "
              "keep their colours"),
          "Shift+Q", &DisplayOptions::refine, true},
         {"reduceInMotion", QT_TRANSLATE_NOOP("hitscope::ShadingActions", "Red&uce in Motion"),
          QT_TRANSLATE_NOOP(
              "hitscope::ShadingActions",
              "While the picture moves and cannot be drawn fast enough (30 times a second, 60 where the CPU "
              "draws): with fewer triangles or pixels"),
          "", &DisplayOptions::reduceInMotion, true}}};
    return kSwitches;
}

ShadingActions::ShadingActions(QObject* parent) : QObject(parent) {}

void ShadingActions::fill(QMenu& menu) {
    menu.setToolTipsVisible(true);
    for (const ShadingSwitch& shading : shadingSwitches()) {
        QAction* action = menu.addAction(tr(shading.text));
        action->setToolTip(tr(shading.toolTip));
        action->setShortcut(QKeySequence(QLatin1String(shading.shortcut)));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this,
                [this, option = shading.option](bool on) { Q_EMIT switched(option, on); });
        m_actions.push_back(action);
    }
}

void ShadingActions::show(const DisplayOptions& options) {
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        m_actions[i]->setChecked(options.*shadingSwitches()[i].option);
    }
}

void ShadingActions::disable(DisplayOption option, const QString& why) {
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        if (shadingSwitches()[i].option == option) {
            enableIf(*m_actions[i], false, why);
        }
    }
}

}  // namespace hitscope
