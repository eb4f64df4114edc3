/// \file
/// Some branches of one tree shown alone, so that one can work inside a dense crown. A way of looking, like
/// the camera: neither saved nor undone, and it changes nothing in the document.
#pragma once

#include "core/qt/document/document.h"
#include <QObject>
#include <memory>
#include <vector>

namespace ramure {

class Isolation : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the object.
    explicit Isolation(Document* document, QObject* parent = nullptr);

    [[nodiscard]] bool isActive() const { return m_node != noNode; }
    /// noNode where everything is shown.
    [[nodiscard]] NodeId node() const { return m_node; }
    /// In the present simplified skeleton of the node, ascending. Branches are remembered by their places:
    /// they stay the same ones when the tree is computed anew. Empty where none of them exists at present;
    /// then the whole tree is shown.
    [[nodiscard]] const std::vector<Index>& branches() const { return m_branches; }

    /// Shows the selected branches alone. If they are alone already, or no branch is selected, everything is
    /// shown again.
    void toggleSelected();

public slots:
    void clear();

signals:
    /// Other branches are shown, or the same ones have other indices.
    void changed();

private:
    void follow(const Change& change);
    /// Nothing where the node has no skeleton at present.
    [[nodiscard]] const TreeResult* tree() const;
    [[nodiscard]] std::vector<Index> present() const;

    Document* m_document;
    NodeId m_node = noNode;
    std::vector<BranchPlace> m_places;
    std::shared_ptr<const SimplifiedSkeleton> m_seen; ///< the skeleton that m_branches index
    std::vector<Index> m_branches;
};

} // namespace ramure
