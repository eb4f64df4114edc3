/// \file
/// "More like this": nine trees of the same numbers that chance grew otherwise, to choose from.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/jobs/variations.h"
#include "widgets/view/tree_pictures.h"
#include <QDialog>
#include <array>

class QCheckBox;
class QLabel;
class QPushButton;

namespace ramure {

class PictureButton;

/// Not modal; stays open, so that one choice can follow another.
class SeedsDialog : public QDialog
{
    Q_OBJECT
public:
    static constexpr int count = 9;

    /// \param document is not owned and must outlive the dialog.
    SeedsDialog(Document* document, QWidget* parent);

    /// A choice adds a tree like \p like, whose id does not count.
    void offerNew(const Node& like);
    /// A choice gives this tree another seed, and where they show three ages an age.
    void offerFor(NodeId tree);
    [[nodiscard]] std::int64_t seedOf(int choice) const;
    [[nodiscard]] const std::array<PictureButton*, count>& choices() const { return m_choices; }
    [[nodiscard]] QPushButton* otherButton() const { return m_other; }
    /// Three seeds, each young, mature and old; hidden of trees that have no age.
    [[nodiscard]] QCheckBox* agesBox() const { return m_agesBox; }
    /// How many of the pictures are drawn.
    [[nodiscard]] int drawn() const { return m_drawn; }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void offer(const Node& like);
    void begin(std::int64_t first, bool named);
    [[nodiscard]] Variation variationOf(int choice) const;
    [[nodiscard]] QString textOf(int choice) const;
    [[nodiscard]] int nextChoice() const;
    void drawNext();
    void choose(int choice);
    void showTexts();

    Document* m_document;
    Node m_like;
    NodeId m_tree = noNode;   ///< the tree whose seed is chosen; none: trees are added
    std::int64_t m_first = 1; ///< first of consecutive seeds
    bool m_named = false;     ///< named seeds are listed first
    bool m_hasNames = false;  ///< there are named seeds for the tree
    std::array<double, 3> m_ages{};
    int m_drawn = 0;
    std::optional<Camera> m_scale; ///< of the oldest tree of a seed
    QString m_problem;
    std::array<PictureButton*, count> m_choices{};
    QLabel* m_hint;
    QCheckBox* m_agesBox;
    QPushButton* m_other;
    TreePictures m_pictures;
};

} // namespace ramure
