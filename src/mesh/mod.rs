//! Joint triangulations: the same connectivity on two point sets.
