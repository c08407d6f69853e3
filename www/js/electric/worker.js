// The worker of the page of electric fields.

import { serveAnswers } from "../common/answering.js";
import { answer } from "./answers.js";

serveAnswers(answer);
