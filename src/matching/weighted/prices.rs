//! Prices of nodes that may stay unpaired.

/// Prices of triangles left over, or of nodes left unpaired.
#[derive(Clone, Copy, Debug, Default)]
pub enum Prices<'a, C> {
    /// Every node must be paired.
    #[default]
    None,
    /// Every node may stay unpaired, at this price.
    Equal(C),
    /// A price for each node that may stay unpaired.
    Each(&'a [Option<C>]),
}

impl<C: Copy + Into<i128>> Prices<'_, C> {
    /// Returns the price of a node.
    ///
    /// # Panics
    /// If prices are given node by node and the node has no entry.
    pub fn of(&self, node: u32) -> Option<i128> {
        match self {
            Self::None => None,
            Self::Equal(price) => Some((*price).into()),
            Self::Each(prices) => prices[node as usize].map(Into::into),
        }
    }

    /// Checks that prices given one by one are as many as nodes.
    ///
    /// # Panics
    /// If they are not.
    pub(super) fn check_count(&self, nodes: usize) {
        if let Self::Each(prices) = self {
            assert_eq!(prices.len(), nodes, "one price a node");
        }
    }
}
