#include "widgets/dialogs/variations/seeds_dialog.h"

#include "core/generators/variety.h"
#include "core/presets/named_seeds.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/planting.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace ramure {
namespace {

constexpr int columns = 3;

} // namespace

SeedsDialog::SeedsDialog(Document* document, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_hint(new QLabel(this))
{
    setObjectName(QStringLiteral("seeds"));
    m_hint->setWordWrap(true);
    auto* grid = new QGridLayout;
    grid->setSpacing(12);
    for (int i = 0; i < count; ++i) {
        m_choices[std::size_t(i)] = new PictureButton(QString(), PictureButton::usualWidth, this);
        grid->addWidget(m_choices[std::size_t(i)], i / columns, i % columns);
        connect(m_choices[std::size_t(i)], &QAbstractButton::clicked, this, [this, i] { choose(i); });
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_other = buttons->addButton(tr("Nine &others"), QDialogButtonBox::ActionRole);
    m_other->setAutoDefault(false);
    connect(m_other, &QPushButton::clicked, this, [this] { begin(seedOf(count - 1) + 1, false); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_hint);
    layout->addLayout(grid);
    layout->addWidget(buttons);
    layout->setSizeConstraint(QLayout::SetFixedSize);
}

void SeedsDialog::offerNew(const Node& like)
{
    m_tree = noNode;
    offer(like);
}

void SeedsDialog::offerFor(NodeId tree)
{
    const Node* like = m_document->scene().find(tree);
    if (!like)
        return;
    m_tree = tree;
    offer(*like);
}

void SeedsDialog::offer(const Node& like)
{
    m_like = like;
    const auto preset = presetParams(like.preset);
    const bool grownAsItShips = preset && preset->weberPenn == like.params.weberPenn &&
                                preset->colonisation == like.params.colonisation;
    begin(like.params.grammar.seed + 1, grownAsItShips && namedSeeds(like.preset));
    show();
    raise();
    activateWindow();
    m_choices.front()->setFocus();
}

std::int64_t SeedsDialog::seedOf(int choice) const
{
    constexpr int named = int(namedSeedCount);
    if (!m_named)
        return m_first + choice;
    return choice < named ? (*namedSeeds(m_like.preset))[std::size_t(choice)] : m_first + choice - named;
}

void SeedsDialog::begin(std::int64_t first, bool named)
{
    m_first = first;
    m_named = named;
    m_drawn = 0;
    m_problem.clear();
    for (PictureButton* choice : m_choices)
        choice->setPicture({});
    showTexts();
    drawNext();
}

void SeedsDialog::drawNext()
{
    if (m_drawn == count)
        return;
    const QSize size = m_choices.front()->pictureSize() * devicePixelRatioF();
    m_pictures.draw(reseeded(m_like.params, seedOf(m_drawn)), size, [this](Expected<QImage>&& made) {
        if (!made) { // the others would not fare better
            m_problem = errorText(made.error());
            return showTexts();
        }
        m_choices[std::size_t(m_drawn++)]->setPicture(QPixmap::fromImage(std::move(*made)));
        showTexts();
        drawNext();
    });
}

void SeedsDialog::choose(int choice)
{
    m_problem.clear();
    std::optional<Error> problem;
    if (m_tree == noNode) {
        Node tree = m_like;
        tree.params = reseeded(std::move(tree.params), seedOf(choice));
        if (auto planted = edit::plantNode(*m_document, std::move(tree)); !planted)
            problem = std::move(planted.error());
    } else if (auto given = edit::reseedTree(*m_document, m_tree, seedOf(choice)); !given) {
        problem = std::move(given.error());
    }
    if (problem)
        m_problem = errorText(*problem);
    showTexts();
}

void SeedsDialog::showTexts()
{
    setWindowTitle(tr("More like %1").arg(presetTitle(QString::fromStdString(m_like.name))));
    const QString choose = m_tree == noNode ? tr("Click a tree to add it to the scene.")
                                            : tr("Click a tree: the one in the scene grows like it.");
    const QString chance =
        m_like.name.empty() || variesByChance(m_like.params)
            ? QString()
            : u' ' +
                  tr("Nothing but the places of its leaves varies: no rule has chances, and the variation of "
                     "angles, lengths and radii is 0 %.");
    m_hint->setText(!m_problem.isEmpty() ? m_problem
                    : m_drawn < count
                        ? choose + chance + u' ' + tr("Growing %1 of %2 …").arg(m_drawn + 1).arg(count)
                        : choose + chance);
    m_hint->setMinimumHeight(2 * fontMetrics().lineSpacing());
    for (int i = 0; i < count; ++i)
        m_choices[std::size_t(i)]->setText(
            m_named && i < int(namedSeedCount)
                ? tr("Seed %1: %2", "2: tall, wide …").arg(seedOf(i)).arg(coreText(seedNames[std::size_t(i)]))
                : tr("Seed %1").arg(seedOf(i)));
}

/// Nobody sees what is not drawn yet.
void SeedsDialog::hideEvent(QHideEvent* event)
{
    m_pictures.stop();
    QDialog::hideEvent(event);
}

} // namespace ramure
