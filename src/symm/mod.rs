//! Symm's equation: region → boundary correspondence.
