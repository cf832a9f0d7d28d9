//! The notations of other systems.

<<<<<<< HEAD
mod click_csv;
=======
mod broken;
>>>>>>> de8a10c (Broken and hostile programs in every notation: bounds for all, operands of the draft are looked at)
mod cplc_draft;
mod hostile;
mod iot;
mod ldmicro;
mod ldmicro_text;
mod textbook;
