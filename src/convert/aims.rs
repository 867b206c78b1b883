//! The aims of `best`, and the problem that they make of a mesh.

use std::fmt;

use super::error::ConvertError;
use crate::mesh::Mesh;
use crate::pairing::{Keeping, Leftover, Objective};
use crate::quadrangulation::{Cost, DefaultCost, Keep, edge_costs, listed_costs};
use crate::triangulation::Surface;

/// The aims of `best`. The default is the least [`DefaultCost`] in sum.
#[derive(Clone, Default)]
#[non_exhaustive]
pub struct Aims<'a> {
    /// Cost of a quad; [`DefaultCost`] if there is none.
    pub cost: Option<&'a dyn Cost>,
    /// Costs edge by edge, in place of `cost`; in the order of [`Surface::edges`].
    pub listed_costs: Option<Vec<i32>>,
    /// Edges that no quad shall lie across.
    pub keep: Keep,
    /// True if none of them is given up.
    pub strict: bool,
    /// Price at which any triangle may be left over, in the unit of the costs.
    pub price: Option<i32>,
}

impl fmt::Debug for Aims<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Aims")
            .field("listed_costs", &self.listed_costs.as_ref().map(Vec::len))
            .field("keep", &self.keep)
            .field("strict", &self.strict)
            .field("price", &self.price)
            .finish_non_exhaustive()
    }
}

impl Aims<'_> {
    /// Returns the question that `best` answers for `surface`, the triangulation of `mesh`. O(n).
    ///
    /// # Errors
    /// Listed costs or edges to keep do not fit the mesh.
    pub fn objective(
        &self,
        surface: &impl Surface,
        mesh: &Mesh,
    ) -> Result<Objective, ConvertError> {
        let costs = match &self.listed_costs {
            Some(list) => listed_costs(surface, list)?,
            None => match self.cost {
                Some(cost) => edge_costs(surface, mesh.positions(), cost),
                // Half as long as through a pointer.
                None => edge_costs(surface, mesh.positions(), &DefaultCost),
            },
        };
        let kept = self.keep.find(surface, mesh)?;
        let keeping = if self.strict { Keeping::All } else { Keeping::AsManyAsCan };
        let leftover = match self.price {
            Some(price) => Leftover::Priced(price),
            None if self.may_leave_triangles() || !surface.is_closed() => Leftover::Fewest,
            None => Leftover::None,
        };
        Ok(Objective::new(costs, kept, keeping, leftover))
    }

    /// Returns whether triangles may be left on closed surfaces, too.
    pub(super) fn may_leave_triangles(&self) -> bool {
        self.strict || self.price.is_some()
    }

    /// Returns the name of something that only `best` can aim at, if there is any.
    pub(super) fn only_for_best(&self) -> Option<&'static str> {
        let aims = [
            (!self.keep.is_empty(), "edges to keep"),
            (self.strict, "strictness"),
            (self.price.is_some(), "a price for triangles"),
            (self.listed_costs.is_some(), "listed costs"),
        ];
        aims.into_iter().find(|aim| aim.0).map(|aim| aim.1)
    }
}
