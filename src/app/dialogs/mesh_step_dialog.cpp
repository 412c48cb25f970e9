// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/mesh_step_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/beside.h"
#include "deform/dent_shape.h"
#include "models/quantity_text.h"
#include "panels/fields/number_box.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

constexpr std::size_t kManyVertices =
    500'000;  // of which the meshes before and after may be too much to undo

constexpr int kPreviewAfter = 250;     // milliseconds after the last change
constexpr float kUsualParts = 100.0f;  // edges along a mesh's largest extent
constexpr float kPartsOfReach = 5.0f;  // edges from a hit to the end of its reach

float twoDigitsOf(float length, float otherwise) {
    return std::isfinite(length) && length > 0.0f ? QString::number(length, 'g', 2).toFloat() : otherwise;
}

bool hasEnabled(const std::vector<Hit>& hits) {
    return std::any_of(hits.begin(), hits.end(), [](const Hit& hit) { return hit.enabled; });
}

}  // namespace

/// What the other thread works out.
struct MeshStepDialog::Preview {
    std::shared_ptr<const MeshData> mesh;
    MeshEdit edit;
    bool proposesLength = false;  ///< at most that of `edit`
    std::atomic<bool> cancelled = false;
    Status status = Done{};
    std::size_t vertices = 0;
    std::size_t faces = 0;

    void make();
    /// What is refined already gets a length that changes something.
    void proposeLength();
};

void MeshStepDialog::Preview::proposeLength() {
    const float half = twoDigitsOf(longestEdge(*mesh, edit) / 2.0f, std::numeric_limits<float>::infinity());
    float& length = std::get<RefineOptions>(edit.step).edgeLength;
    length = std::min(length, half);
}

void MeshStepDialog::Preview::make() {
    if (proposesLength) {
        proposeLength();
    }
    const Result<EditedMesh> made = edited(*mesh, edit, [this](double) { return !cancelled; });
    if (made) {
        vertices = made.value().mesh.vertexCount();
        faces = made.value().mesh.faceCount();
    } else {
        status = made.error();
    }
}

MeshStepDialog::MeshStepDialog(Kind kind, std::shared_ptr<const MeshData> mesh, const QString& target,
                               MeshEdit edit, QWidget* parent)
    : QDialog(parent), m_kind(kind), m_mesh(std::move(mesh)), m_edit(std::move(edit)) {
    const char* const names[] = {"refineDialog", "simplifyDialog", "smoothDialog"};
    const QString titles[] = {tr("Refine Mesh"), tr("Simplify Mesh"), tr("Smooth Mesh")};
    const QString buttons[] = {tr("&Refine"), tr("S&implify"), tr("S&mooth")};
    setObjectName(QLatin1String(names[static_cast<int>(kind)]));
    setWindowTitle(titles[static_cast<int>(kind)]);
    auto* form = new QFormLayout(this);
    auto* name = new QLabel(target, this);
    name->setTextFormat(Qt::PlainText);
    form->addRow(tr("Target:"), name);
    kind == Kind::Refine ? makeRefineRows(*form) : makeOtherRows(*form);
    makeRegionRow(*form);
    if (kind != Kind::Refine) {
        makeApplyRow(*form);
    }
    m_result = new QLabel(this);
    m_result->setObjectName(QStringLiteral("result"));
    m_result->setTextFormat(Qt::PlainText);
    m_result->setWordWrap(true);
    m_result->setMinimumWidth(fontMetrics().averageCharWidth() * 50);
    m_result->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_result->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    form->addRow(tr("Result:"), m_result);
    auto* box = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = box->addButton(buttons[static_cast<int>(kind)], QDialogButtonBox::AcceptRole);
    m_accept->setObjectName(QStringLiteral("accept"));
    connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(box);
    box->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    m_accept->setDefault(true);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kPreviewAfter);
    connect(&m_soon, &QTimer::timeout, this, &MeshStepDialog::beginPreview);
    follow();
}

MeshStepDialog::~MeshStepDialog() {
    stopPreview();
}

/// Short enough for dents where there are hits, else a hundredth of the mesh.
float MeshStepDialog::usualLength() const {
    float length = std::numeric_limits<float>::infinity();
    for (const Hit& hit : m_edit.hits) {
        length = std::min(length, reachOf(hit).radius / kPartsOfReach);
    }
    if (!std::isfinite(length)) {
        const glm::vec3 size = m_mesh->bounds().size();
        length = std::max({size.x, size.y, size.z}) / kUsualParts;
    }
    return twoDigitsOf(length, 0.1f);
}

void MeshStepDialog::makeRefineRows(QFormLayout& form) {
    m_length = new NumberBox(this);
    m_length->setObjectName(QStringLiteral("edgeLength"));
    m_length->setRange(1.0e-9, 1.0e9);
    m_length->setSuffix(tr(" m"));
    m_length->setToolTip(tr("No edge in the region is longer afterwards"));
    propose(usualLength());
    m_length->setFocus();
    m_length->selectAll();
    form.addRow(tr("&Edge length:"), m_length);
    m_method = new QComboBox(this);
    m_method->setObjectName(QStringLiteral("method"));
    m_method->addItems({tr("Midpoint"), tr("Longest edge"), tr("Modified butterfly")});  // by RefineMethod
    m_method->setToolTip(
        tr("Midpoint and longest edge keep the shape; modified butterfly puts new vertices on "
           "a smooth surface through the old ones"));
    form.addRow(tr("&Method:"), m_method);
    m_keepQuads = new QCheckBox(tr("&Quads stay quads"), this);
    m_keepQuads->setObjectName(QStringLiteral("keepQuads"));
    m_keepQuads->setToolTip(tr("Otherwise polygons that are too large are cut into triangles"));
    m_keepQuads->setChecked(true);
    form.addRow({}, m_keepQuads);
    connect(m_length, &NumberBox::edited, this, [this](double length) {
        m_proposesLength = m_proposesLength && length == static_cast<double>(m_proposed);
        follow();
    });
    connect(m_method, &QComboBox::currentIndexChanged, this, &MeshStepDialog::follow);
    connect(m_keepQuads, &QCheckBox::toggled, this, &MeshStepDialog::follow);
}

void MeshStepDialog::propose(float length) {
    const double before = m_length->value();
    m_proposed = length;
    m_length->showNumber(static_cast<double>(length));
    if (m_length->hasFocus() && m_length->value() != before) {
        m_length->selectAll();  // who types replaces it
    }
}

void MeshStepDialog::makeOtherRows(QFormLayout& form) {
    auto* number = new QSpinBox(this);
    if (m_kind == Kind::Simplify) {
        m_share = number;
        number->setObjectName(QStringLiteral("share"));
        number->setRange(1, 99);
        number->setValue(50);
        number->setSuffix(tr(" %"));
        number->setToolTip(tr("Of the triangles in the region, those that are to stay"));
        form.addRow(tr("&Keep:"), number);
    } else {
        m_passes = number;
        number->setObjectName(QStringLiteral("passes"));
        number->setRange(1, SmoothOptions::kMostPasses);
        number->setValue(SmoothOptions().passes);
        number->setToolTip(tr("Each moves a vertex half the way to the middle of its neighbours"));
        form.addRow(tr("&Passes:"), number);
        m_keepBorders = new QCheckBox(tr("Keep &borders"), this);
        m_keepBorders->setObjectName(QStringLiteral("keepBorders"));
        m_keepBorders->setToolTip(tr("Vertices at open edges stay where they are"));
        m_keepBorders->setChecked(true);
        form.addRow({}, m_keepBorders);
        connect(m_keepBorders, &QCheckBox::toggled, this, &MeshStepDialog::follow);
    }
    number->setFocus();
    number->selectAll();
    connect(number, &QSpinBox::valueChanged, this, &MeshStepDialog::follow);
}

void MeshStepDialog::makeRegionRow(QFormLayout& form) {
    m_region = new QComboBox(this);
    m_region->setObjectName(QStringLiteral("region"));
    m_region->addItems({tr("The whole target"), tr("Around selected vertices"), tr("Where hits are")});
    const auto* model = qobject_cast<QStandardItemModel*>(m_region->model());
    model->item(1)->setEnabled(!m_edit.selected.empty());
    model->item(2)->setEnabled(hasEnabled(m_edit.hits));
    m_region->setToolTip(tr("Selected vertices and hits can be chosen where the target has some"));
    m_region->setCurrentIndex(hasEnabled(m_edit.hits) ? 2 : 0);
    form.addRow(tr("&Where:"), m_region);
    connect(m_region, &QComboBox::currentIndexChanged, this, &MeshStepDialog::follow);
}

void MeshStepDialog::makeApplyRow(QFormLayout& form) {
    m_apply = new QCheckBox(tr("&Apply hits first"), this);
    m_apply->setObjectName(QStringLiteral("applyHits"));
    m_apply->setToolTip(
        tr("The dented shape becomes the original, and its hits leave the history. Otherwise the "
           "original is changed, and the hits dent it again"));
    m_apply->setChecked(hasEnabled(m_edit.hits));
    enableIf(*m_apply, hasEnabled(m_edit.hits), tr("The target has no hits."));
    form.addRow({}, m_apply);
    connect(m_apply, &QCheckBox::toggled, this, &MeshStepDialog::follow);
}

MeshEdit MeshStepDialog::edit() const {
    MeshEdit edit = m_edit;
    if (m_kind == Kind::Refine) {
        edit.step = RefineOptions{.method = static_cast<RefineMethod>(m_method->currentIndex()),
                                  .edgeLength = static_cast<float>(m_length->value()),
                                  .keepQuads = m_keepQuads->isEnabled() && m_keepQuads->isChecked(),
                                  .region = {}};
    } else if (m_kind == Kind::Simplify) {
        edit.step = SimplifyOptions{.share = static_cast<float>(m_share->value()) / 100.0f, .region = {}};
    } else {
        edit.step = SmoothOptions{
            .passes = m_passes->value(), .keepBorders = m_keepBorders->isChecked(), .region = {}};
    }
    constexpr MeshEdit::Where kWhere[] = {MeshEdit::Where::Whole, MeshEdit::Where::Selection,
                                          MeshEdit::Where::Hits};
    edit.where = kWhere[m_region->currentIndex()];
    edit.appliesHits = m_apply != nullptr && m_apply->isChecked();
    return edit;
}

MeshStepDialog::Choice MeshStepDialog::choice() const {
    const auto isOn = [](const QCheckBox* box) { return box != nullptr && box->isChecked() ? 1.0 : 0.0; };
    return {m_length != nullptr   ? m_length->value()
            : m_share != nullptr  ? m_share->value()
            : m_passes != nullptr ? m_passes->value()
                                  : 0.0,
            m_method != nullptr ? m_method->currentIndex() : 0.0,
            isOn(m_keepQuads),
            isOn(m_keepBorders),
            static_cast<double>(m_region->currentIndex()),
            isOn(m_apply)};
}

void MeshStepDialog::keyPressEvent(QKeyEvent* event) {
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    m_acceptsWhenReady = isReturn && !m_accept->isEnabled() && (m_preview || m_soon.isActive());
    QDialog::keyPressEvent(event);
}

void MeshStepDialog::follow() {
    // Boxes tell their number again with each press of Return.
    if (std::exchange(m_choice, choice()) == m_choice) {
        return;
    }
    m_acceptsWhenReady = false;
    if (m_keepQuads != nullptr) {
        enableIf(*m_keepQuads, m_method->currentIndex() == 0, tr("Only midpoint keeps quads."));
    }
    stopPreview();
    m_result->setText(tr("Computing…"));
    enableIf(*m_accept, false, tr("What comes of it is being computed."));
    m_soon.start();
}

void MeshStepDialog::stopPreview() {
    if (m_preview) {
        m_preview->cancelled = true;
        m_preview.reset();
    }
}

void MeshStepDialog::beginPreview() {
    const auto preview = std::make_shared<Preview>();
    preview->mesh = m_mesh;
    preview->edit = edit();
    if (m_kind == Kind::Refine && m_proposesLength) {
        preview->proposesLength = true;
        std::get<RefineOptions>(preview->edit.step).edgeLength = usualLength();
    }
    m_preview = preview;
    workBeside(
        this, [preview] { preview->make(); },
        [preview](MeshStepDialog& self, bool done) {
            if (self.m_preview == preview) {
                self.showPreview(*preview, done);
            }
        });
}

QString MeshStepDialog::resultText(const Preview& preview, bool changes) const {
    if (!preview.status) {
        return QString::fromStdString(preview.status.error().message());
    }
    if (!changes) {
        return tr("The mesh stays as it is: no edge there is longer.");
    }
    QString text = tr("Vertices: %1 → %2. Faces: %3 → %4.")
                       .arg(countText(m_mesh->vertexCount()), countText(preview.vertices),
                            countText(m_mesh->faceCount()), countText(preview.faces));
    if (preview.vertices > kManyVertices) {
        text += u' ' + tr("Steps before it may be forgotten: what is kept to undo takes 512 MiB at most.");
    }
    return text;
}

void MeshStepDialog::showPreview(const Preview& preview, bool done) {
    if (preview.proposesLength) {
        propose(std::get<RefineOptions>(preview.edit.step).edgeLength);
        m_choice = choice();
    }
    const bool changes = m_kind != Kind::Refine || preview.vertices != m_mesh->vertexCount() ||
                         preview.faces != m_mesh->faceCount();
    m_result->setText(done ? resultText(preview, changes) : tr("There is not enough memory for it."));
    enableIf(*m_accept, done && preview.status.ok() && changes, tr("Nothing comes of it."));
    m_preview.reset();
    if (m_acceptsWhenReady && m_accept->isEnabled()) {
        accept();
        return;
    }
    // What is wrong may take more lines than what comes of it.
    resize(width(), std::max(height(), layout()->heightForWidth(width())));
}

}  // namespace hitscope
